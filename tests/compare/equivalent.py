"""What POV-Ray is given for a scene: itself, or an equivalent text where the course dialect differs.

README.md in this folder says why each change is made. The text is taken apart into tokens and only what
must be changed is replaced, so that a mistake here shows as a difference of pictures and not as none.
"""
import math
import re

COURSE_WORDS = set('''
    sphere box cone cylinder quadric polygon pigment finish interior translate rotate scale
    camera location look_at angle up right light_source color colour rgb rgbf red green blue filter
    ambient diffuse phong phong_size metallic reflection ior
    global_settings ambient_light max_trace_level adc_bailout'''.split())

TOKEN = re.compile(r'''(?P<space>\s+)|(?P<line>//[^\n]*)|(?P<word>[A-Za-z_]\w*)
                     |(?P<number>[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)|(?P<sign>.)''', re.X | re.S)
PREAMBLE = '#version 3.7;\nglobal_settings { assumed_gamma 1.0 ambient_light rgb <0,0,0> }\n'
COURSE_RIGHT = (1.33333, 0.0, 0.0)


def strip_comments(text):
    """The text with each comment as one space; block comments nest."""
    out, depth, at = [], 0, 0
    while at < len(text):
        pair = text[at:at + 2]
        if pair == '/*':
            depth += 1
            at += 2
        elif pair == '*/' and depth:
            depth -= 1
            at += 2
            out.append(' ')
        elif pair == '//' and not depth:
            at = (text + '\n').index('\n', at)
        else:
            if not depth:
                out.append(text[at])
            at += 1
    return ''.join(out)


def tokens(text):
    """The words, numbers and signs of a text without comments."""
    return [match.group() for match in TOKEN.finditer(strip_comments(text)) if not match.group('space')]


def dialect(text):
    """"course" or "povray", by the rule of docs/language.md."""
    for token in tokens(text):
        if re.match(r'[A-Za-z_]', token):
            if token not in COURSE_WORDS:
                return 'povray'
        elif not re.match(r'[-+.\d<>{},]', token) or token in '+-':
            return 'povray'
    return 'course'


def povray_text(text):
    """The text that makes POV-Ray draw what the scene means."""
    return text if dialect(text) == 'povray' else from_course(text)


def from_course(text):
    """A course scene in POV-Ray's own words."""
    words, out, cameras, at = tokens(text), [], [], 0
    while at < len(words):
        if words[at] == 'camera':
            end = block_end(words, at + 1)
            cameras.append(words[at + 2:end])
            at = end + 1
        elif words[at] == 'sphere' and is_number(words[at + 2]) and not is_number(after_comma(words, at + 3)):
            out += ['sphere', '{', '<0,0,0>', ',']
            at += 2
        else:
            out.append(words[at])
            at += 1
    return PREAMBLE + camera_text(cameras[-1] if cameras else []) + '\n' + one_object_a_line(out) + '\n'


def one_object_a_line(words):
    """The tokens with a line's end after each block of the outermost level."""
    out, depth = [], 0
    for word in words:
        depth += (word == '{') - (word == '}')
        out.append(word + ('\n' if word == '}' and depth == 0 else ' '))
    return ''.join(out)


def block_end(words, opening):
    """Where the block ends whose "{" stands at opening."""
    depth = 0
    for at in range(opening, len(words)):
        depth += (words[at] == '{') - (words[at] == '}')
        if depth == 0:
            return at
    raise ValueError('a block is not closed')


def is_number(word):
    return re.fullmatch(r'[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?', word) is not None


def after_comma(words, at):
    return words[at + 1] if words[at] == ',' else words[at]


def read_vector(words, at):
    """A vector, or a number promoted to one: its value, and where the next word is."""
    if is_number(words[at]):
        return (float(words[at]),) * 3, at + 1
    end = words.index('>', at)
    return tuple(float(word) for word in words[at + 1:end] if word != ','), end + 1


def camera_text(words):
    """A course camera: `up` becomes `sky`, the default `right` is the course's, `look_at` is always given."""
    location, look_at, up, right, angle = (0.0, 0.0, 0.0), None, (0.0, 1.0, 0.0), COURSE_RIGHT, ''
    transforms, at = '', 0
    while at < len(words):
        word = words[at]
        value, at = read_vector(words, at + 1)
        if word == 'location':
            location = value
        elif word == 'look_at':
            look_at = value
        elif word == 'up':
            up = value
        elif word == 'right':
            right = value
        elif word == 'angle':
            angle = f' angle {value[0]!r}'
        else:
            transforms += f' {word} {vector_text(value)}'
    if look_at is None:
        look_at = (location[0], location[1], location[2] + 1)
    sky = up if not parallel(up, location, look_at) else (1.0, 0.0, 0.0)
    return (f'camera {{ location {vector_text(location)} right <{math.hypot(*right)!r},0,0> '
            f'up <0,{math.hypot(*up)!r},0> sky {vector_text(sky)} look_at {vector_text(look_at)}'
            f'{angle}{transforms} }}')


def parallel(up, location, look_at):
    """Whether `up` has no part across the view."""
    view = [b - a for a, b in zip(location, look_at)]
    cross = [up[i - 2] * view[i - 1] - up[i - 1] * view[i - 2] for i in range(3)]
    return math.hypot(*cross) <= 1e-12 * math.hypot(*up) * math.hypot(*view)


def vector_text(vector):
    return '<' + ','.join(repr(component) for component in vector) + '>'
