"""Runs povc on malformed scenes: malformed.py POVC SCENES_FOLDER. Prints what went wrong, and how many were run.

Each text must end in exit status 1 with a message FILE:LINE:COLUMN, within seconds, leave the picture of that name as
it was, and leave nothing beside it."""
import os
import random
import subprocess
import sys

HEAD = b"camera { location <0, 0, -4> look_at 0 }\n"
SPHERE = b"sphere { <0, 0, 0>, 1 pigment { color rgb <1, 1, 1> } }\n"

BODIES = {
    "unknown-object": b"sphare { <0,0,0>, 1 }", "unknown-modifier": b"sphere { <0,0,0>, 1 pigmnt { rgb 1 } }",
    "unknown-statement": b"frobnicate", "number-for-vector": b'box { "a", <1,1,1> }', "word-for-number": b"sphere { <0,0,0>, angle }",
    "no-radius": b"sphere { <0,1,0> }", "no-corner": b"box { <0,0,0> }", "no-brace": b"sphere <0,0,0>, 1 }",
    "unclosed": b"sphere { <0,0,0>, 1", "unclosed-vector": b"sphere { <0,0,0, 1 }", "four-in-vector": b"sphere { <0,0,0,0,0,0>, 1 }",
    "extra-brace": SPHERE + b"}", "nan": b"sphere { <nan,0,0>, 1 }", "inf": b"sphere { <inf,0,0>, 1 }",
    "overflow": b"sphere { <1e400,0,0>, 1 }", "negative-overflow": b"sphere { <-1e400,0,0>, 1 }", "two-dots": b"sphere { <1.2.3,0,0>, 1 }",
    "two-signs": b"sphere { <--,0,0>, 1 }", "lone-exponent": b"sphere { <e5,0,0>, 1 }", "lone-dot": b"sphere { <.,0,0>, 1 }",
    "cone-no-length": b"cone { <0,0,0>, 1, <0,0,0>, 2 }", "cylinder-no-length": b"cylinder { <1,1,1>, <1,1,1>, 2 }",
    "polygon-two": b"polygon { 2, <0,0,0>, <1,0,0> }", "polygon-none": b"polygon { 0 }", "polygon-short": b"polygon { 4, <0,0,0>, <1,0,0>, <1,1,0> }",
    "polygon-warped": b"polygon { 4, <0,0,0>, <1,0,0>, <1,1,.5>, <0,1,0> }", "polygon-negative": b"polygon { -3, <0,0,0>, <1,0,0>, <1,1,0> }",
    "polygon-huge": b"polygon { 1e18, <0,0,0>, <1,0,0>, <1,1,0> }", "quadric-short": b"quadric { <1,1,1>, <0,0,0>, <0,0,0> }",
    "look-at-location": b"camera { location <1,1,1> look_at <1,1,1> }", "angle-180": b"camera { angle 180 }", "angle-negative": b"camera { angle -5 }",
    "angle-zero": b"camera { angle 0 }", "camera-unknown": b"camera { locaton <0,0,0> }", "camera-unclosed": b"camera { location <0,0,0>",
    "light-no-brace": b"light_source <0,0,0>", "light-number": b"light_source { } ", "pigment-string": b'sphere { 0, 1 pigment { "red" } }',
    "pigment-unclosed": b"sphere { 0, 1 pigment { color rgb <1,1,1> ", "finish-number": b"sphere { 0, 1 finish { 5 } }",
    "finish-unknown": b"sphere { 0, 1 finish { shiny 1 } }", "finish-no-value": b"sphere { 0, 1 finish { phong } }",
    "ior-word": b"sphere { 0, 1 interior { ior glass } }", "ior-negative": b"sphere { 0, 1 interior { ior -1 } }",
    "rotate-word": b"sphere { 0, 1 rotate x_axis }", "translate-nothing": b"sphere { 0, 1 translate }", "matrix-short": b"sphere { 0, 1 matrix <1,0,0> }",
    "matrix-flat": b"sphere { 0, 1 matrix <1,1,0, 1,1,0, 0,0,1, 0,0,0> }", "comment-open": b"/* and no end", "comment-nested-open": b"/* /* */",
    "string-open": b'sphere { 0, 1 pigment { "red', "declare": b"#declare R = 1", "include": b'#include "no such file"', "macro": b"#macro M() M() #end M()",
    "while": b"#while (1", "hash-only": b"#", "hash-unknown": b"#frobnicate", "version-word": b"#version many;",
    "union": b"union { sphere { 0, 1 }", "torus": b"torus { 1, .2", "fog": b"fog { distance 1", "normal": b"sphere { 0, 1 normal { bumps 1 }",
    "global-unknown": b"global_settings { ambience 1 }", "global-level": b"global_settings { max_trace_level -1 }", "global-gamma": b"global_settings { assumed_gamma 0 }",
    "zero-byte": b"sphere { 0,\0 1 }", "control": b"sphere { 0, \x01 1 }", "at-sign": b"@", "backslash": b"\\", "latin-word": b"sph\xe8re { 0, 1 }",
    "keyword-as-object": b"pigment { color rgb 1 }", "close-first": b"}", "comma-first": b", sphere { 0, 1 }", "vector-alone": b"<1,2,3>",
    "long-word": b"a" * 100000, "long-number": b"sphere { 0, " + b"9" * 400 + b" }", "path-word": b"../../etc/passwd { }",
    "deep-texture": b"sphere { 0, 1 " + b"texture { " * 10000 + b"} " * 10000 + b"}",
}
WHOLE = {
    "braces": b"{" * 10000, "close-braces": b"}" * 10000,
    "angles": b"<" * 10000, "binary": bytes(random.Random(1).randrange(256) for _ in range(5000)),
    "elf": open(sys.executable, "rb").read(4096), "utf16": "sphere { 0, 1 }".encode("utf-16"),
    "utf16be": b"\xfe\xff" + "sphere { 0, 1 }".encode("utf-16-be"), "open-comments": b"/*" * 10000, "hashes": b"#" * 10000,
}


def cuts(folder, count):
    """Scenes cut off in the middle of something that is open: before the last closing brace of one of its objects."""
    rng = random.Random(2)
    names = sorted(n for n in os.listdir(folder) if n.endswith(".pov"))
    for name in rng.sample(names, count):
        text = open(os.path.join(folder, name), "rb").read()
        yield "cut-" + name[:-4], text[:text.rindex(b"}")]


def all_texts(folder):
    for name, body in BODIES.items():
        yield name, HEAD + SPHERE + body + b"\n"
    yield from WHOLE.items()
    yield from cuts(folder, 25)


def complaint(povc, name, text):
    path = "m-%s.pov" % name
    with open(path, "wb") as out:
        out.write(text)
    with open("out.png", "w") as out:
        out.write("the old picture")
    before = sorted(os.listdir("."))
    try:
        run = subprocess.run([povc, path, "16", "12", "out.png", "-q"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=20)
    except subprocess.TimeoutExpired:
        return "it hangs"
    message = run.stderr.decode("utf-8", "replace")
    place = message.split(": error: ")[0].split("\n")[-1]
    parts = place.rsplit(":", 2)
    if run.returncode != 1:
        return "exit status %d: %s" % (run.returncode, message[:300])
    if len(parts) != 3 or parts[0] != path or not (parts[1].isdigit() and parts[2].isdigit() and int(parts[1]) >= 1):
        return "no place in: " + message[:300]
    if open("out.png").read() != "the old picture" or sorted(os.listdir(".")) != before:
        return "the old picture was touched"
    os.remove(path)
    return None


def main():
    povc, folder = sys.argv[1:]
    count = bad = 0
    for name, text in all_texts(folder):
        wrong = complaint(povc, name, text)
        count += 1
        if wrong:
            bad += 1
            print("%s: %s" % (name, wrong))
    print("%d malformed texts, %d wrong" % (count, bad))
    sys.exit(bad > 0 or count < 80)


main()
