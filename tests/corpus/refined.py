"""A scene whose noise or caches POV-Ray's own settings leave coarse, as text that asks POV-Ray for finer ones.

POV-Ray integrates media by a fixed number of samples, keeps radiosity in a cache and blurs photons; povc converges to the
same integrals. So their pictures are held against each other where both have converged: POV-Ray by these words, povc by its
samples. The words change how long POV-Ray takes and how large its error is, not what the scene means.
"""
import re

MEDIA = ' method 3 intervals 1 samples 200 '
RADIOSITY = ' count 1200 error_bound 0.2 nearest_count 8 low_error_factor 0.5 pretrace_start 0.08 pretrace_end 0.01 minimum_reuse 0.005 '


def without_comments(text):
    return re.sub(r'//[^\n]*|/\*.*?\*/', ' ', text, flags=re.S)


def at_end_of_blocks(text, word, extra):
    """The last setting in a block counts, so that what is added at its end decides."""
    out, begin = '', 0
    for match in re.finditer(r'\b' + word + r'\s*\{', text):
        if match.start() < begin:
            continue
        depth, end = 1, match.end()
        while end < len(text) and depth:
            depth += {'{': 1, '}': -1}.get(text[end], 0)
            end += 1
        out += text[begin:end - 1] + extra + text[end - 1:end]
        begin = end
    return out + text[begin:]


def refined(text):
    text = without_comments(text)
    # Where the samples of a media have a name or stand in a declaration, a block cannot be told from one that refers to it.
    text, found = re.subn(r'\bsamples\s+[\w.]+(\s*,\s*[\w.]+)?', 'samples 200', text)
    text = re.sub(r'\bintervals\s+[\w.]+', 'intervals 1', re.sub(r'\bmethod\s+[12]\b', 'method 3', text))
    text = re.sub(r'\b(confidence|variance)\s+[\d.]+(/[\d.]+)?', '', text)
    if not found:
        text = at_end_of_blocks(text, 'media', MEDIA)
    return at_end_of_blocks(text, 'radiosity', RADIOSITY)
