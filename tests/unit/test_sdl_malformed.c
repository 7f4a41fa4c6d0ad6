/* sdl: texts that are wrong, and what is said of each: status, place, message, guess. */
#include "support/check.h"
#include "support/reading.h"

#include <stdlib.h>
#include <string.h>

typedef struct malformed {
    const char *text;
    size_t length;
    pov_status status;
    int line, column;
    const char *message, *hint;
} malformed;

enum { TOLD_IN_MACROS = 240 };   /* of the cases below; some are no text that a macro can hold */

#define TEXT(text) text, sizeof(text) - 1

static const malformed cases[] = {
    { TEXT("/*"), POV_E_SYNTAX, 1, 1,
      "the comment that begins here has no end", "" },
    { TEXT("sphere { 0, 1 } /* /* */"), POV_E_SYNTAX, 1, 17,
      "the comment that begins here has no end", "" },
    { TEXT("sphere { 0, 1 }\n/* never ends\n\n"), POV_E_SYNTAX, 2, 1,
      "the comment that begins here has no end", "" },
    { TEXT("*/"), POV_E_SYNTAX, 1, 1,
      "expected an object or a setting, found \"*\"", "" },
    { TEXT("sphere"), POV_E_SYNTAX, 1, 7,
      "expected \"{\" after \"sphere\", found the end of the text", "" },
    { TEXT("sphere {"), POV_E_SYNTAX, 1, 9,
      "expected a vector after \"{\", found the end of the text;"
      " the \"{\" of \"sphere\" at 1:8 is still open", "" },
    { TEXT("sphere { 0"), POV_E_SYNTAX, 1, 11,
      "expected an object modifier or \"}\" after \"0\", found the end of the text;"
      " the \"{\" of \"sphere\" at 1:8 is still open", "" },
    { TEXT("sphere { 0,"), POV_E_SYNTAX, 1, 12,
      "expected an object modifier or \"}\" after \",\", found the end of the text;"
      " the \"{\" of \"sphere\" at 1:8 is still open", "" },
    { TEXT("sphere { <"), POV_E_SYNTAX, 1, 11,
      "expected a number after \"<\", found the end of the text;"
      " the \"{\" of \"sphere\" at 1:8 is still open", "" },
    { TEXT("sphere { <0"), POV_E_SYNTAX, 1, 12,
      "expected a number after \"0\", found the end of the text;"
      " the \"{\" of \"sphere\" at 1:8 is still open", "" },
    { TEXT("sphere { <0,"), POV_E_SYNTAX, 1, 13,
      "expected a number after \",\", found the end of the text;"
      " the \"{\" of \"sphere\" at 1:8 is still open", "" },
    { TEXT("sphere { <0, 0, 0"), POV_E_SYNTAX, 1, 18,
      "expected a number after \"0\", found the end of the text; the \"{\" of \"sphere\" at 1:8 is still open", "" },
    { TEXT("sphere { <0, 0, 0>"), POV_E_SYNTAX, 1, 19,
      "expected an object modifier or \"}\" after \">\", found the end of the text;"
      " the \"{\" of \"sphere\" at 1:8 is still open", "" },
    { TEXT("sphere { <0, 0, 0>,"), POV_E_SYNTAX, 1, 20,
      "expected an object modifier or \"}\" after \",\", found the end of the text;"
      " the \"{\" of \"sphere\" at 1:8 is still open", "" },
    { TEXT("sphere { <0, 0, 0>, 1"), POV_E_SYNTAX, 1, 22,
      "expected an object modifier or \"}\" after \"1\", found the end of the text;"
      " the \"{\" of \"sphere\" at 1:8 is still open", "" },
    { TEXT("sphere { <0, 0, 0>, 1\n\n"), POV_E_SYNTAX, 1, 22,
      "expected an object modifier or \"}\" after \"1\", found the end of the text;"
      " the \"{\" of \"sphere\" at 1:8 is still open", "" },
    { TEXT("sphere { 0, 1 pigment"), POV_E_SYNTAX, 1, 22,
      "expected \"{\" after \"pigment\", found the end of the text;"
      " the \"{\" of \"sphere\" at 1:8 is still open", "" },
    { TEXT("sphere { 0, 1 pigment {"), POV_E_SYNTAX, 1, 24,
      "expected a colour or \"}\" after \"{\", found the end of the text;"
      " the \"{\" of \"pigment\" at 1:23 is still open", "" },
    { TEXT("sphere {\n  0, 1\n  pigment { rgb 1\n"), POV_E_SYNTAX, 3, 18,
      "expected a colour or \"}\" after \"1\", found the end of the text; the \"{\" of \"pigment\" at 3:11 is still open", "" },
    { TEXT("sphere 0, 1 }"), POV_E_SYNTAX, 1, 8,
      "expected \"{\" after \"sphere\", found \"0\"", "" },
    { TEXT("sphere <0, 0, 0>, 1"), POV_E_SYNTAX, 1, 8,
      "expected \"{\" after \"sphere\", found \"<\"", "" },
    { TEXT("sphere ( 0, 1 )"), POV_E_SYNTAX, 1, 8,
      "expected \"{\" after \"sphere\", found \"(\"", "" },
    { TEXT("sphere { 0, 1 }}"), POV_E_SYNTAX, 1, 16,
      "expected an object or a setting after \"}\", found \"}\"", "" },
    { TEXT("{"), POV_E_SYNTAX, 1, 1,
      "expected an object or a setting, found \"{\"", "" },
    { TEXT("}"), POV_E_SYNTAX, 1, 1,
      "expected an object or a setting, found \"}\"", "" },
    { TEXT("5"), POV_E_SYNTAX, 1, 1,
      "expected an object or a setting, found \"5\"", "" },
    { TEXT("\"sphere\""), POV_E_SYNTAX, 1, 1,
      "expected an object or a setting, found the string \"sphere\"", "" },
    { TEXT(", sphere { 0, 1 }"), POV_E_SYNTAX, 1, 1,
      "expected an object or a setting, found \",\"", "" },
    { TEXT("sphare { 0, 1 }"), POV_E_SYNTAX, 1, 1,
      "unknown word \"sphare\"", "sphere" },
    { TEXT("Sphere { 0, 1 }"), POV_E_SYNTAX, 1, 1,
      "unknown word \"Sphere\"", "sphere" },
    { TEXT("spheres { 0, 1 }"), POV_E_SYNTAX, 1, 1,
      "unknown word \"spheres\"", "sphere" },
    { TEXT("nonsense"), POV_E_SYNTAX, 1, 1,
      "unknown word \"nonsense\"", "" },
    { TEXT("camara { }"), POV_E_SYNTAX, 1, 1,
      "unknown word \"camara\"", "camera" },
    { TEXT("nan"), POV_E_SYNTAX, 1, 1,
      "unknown word \"nan\"", "" },
    { TEXT("sphere { nan, 1 }"), POV_E_SYNTAX, 1, 10,
      "\"nan\" is not declared", "tan" },
    { TEXT("sphere { 0, inf }"), POV_E_SYNTAX, 1, 13,
      "unknown word \"inf\" in \"sphere\"", "" },
    { TEXT("sphere { 0, NaN }"), POV_E_SYNTAX, 1, 13,
      "unknown word \"NaN\" in \"sphere\"", "" },
    { TEXT("sphere { 0, 1e400 }"), POV_E_SYNTAX, 1, 13,
      "inf is no number that can stand here", "" },
    { TEXT("sphere { 0, -1e400 }"), POV_E_SYNTAX, 1, 13,
      "-inf is no number that can stand here", "" },
    { TEXT("sphere { 0, 1e400 - 1e400 }"), POV_E_SYNTAX, 1, 13,
      "nan is no number that can stand here", "" },
    { TEXT("sphere { 0, -(1e400 - 1e400) }"), POV_E_SYNTAX, 1, 15,
      "nan is no number that can stand here", "" },
    { TEXT("sphere { 0, 1.2.3 }"), POV_E_SYNTAX, 1, 13,
      "\"1.2.3\" is not a number", "" },
    { TEXT("sphere { 0, 2x }"), POV_E_SYNTAX, 1, 14,
      "\"x\" does not belong in \"sphere\"", "" },
    { TEXT("sphere { 0, 0x10 }"), POV_E_SYNTAX, 1, 14,
      "unknown word \"x10\" in \"sphere\"", "" },
    { TEXT("sphere { 0, . }"), POV_E_SYNTAX, 1, 13,
      "expected an object modifier or \"}\" after \",\", found \".\"", "" },
    { TEXT("sphere { <0, 0, 0, 0>, 1 }"), POV_E_SYNTAX, 1, 10,
      "expected a vector, found one of 4 components", "" },
    { TEXT("sphere { <0>, 1 }"), POV_E_SYNTAX, 1, 12,
      "expected a number after \"0\", found \">\"", "" },
    { TEXT("sphere { <>, 1 }"), POV_E_SYNTAX, 1, 11,
      "expected a number after \"<\", found \">\"", "" },
    { TEXT("sphere { <0,, 0, 0>, 1 }"), POV_E_SYNTAX, 1, 13,
      "expected a number after \",\", found \",\"", "" },
    { TEXT("sphere { \"0\", 1 }"), POV_E_SYNTAX, 1, 10,
      "expected a vector, found a string", "" },
    { TEXT("sphere { 0, \"1\" }"), POV_E_SYNTAX, 1, 13,
      "expected an object modifier or \"}\" after \",\", found the string \"1\"", "" },
    { TEXT("sphere { 0, <1, 1, 1> }"), POV_E_SYNTAX, 1, 20,
      "expected a number, found a vector", "" },
    { TEXT("sphere { 0, 1, pigment { rgb 1 } }"), POV_E_SYNTAX, 1, 14,
      "expected an object modifier or \"}\" after \"1\", found \",\"", "" },
    { TEXT("sphere { 0, 1 2 }"), POV_E_SYNTAX, 1, 15,
      "expected an object modifier or \"}\" after \"1\", found \"2\"", "" },
    { TEXT("sphere { 0, 1 sphere { 0, 1 } }"), POV_E_SYNTAX, 1, 15,
      "\"sphere\" does not belong in \"sphere\"", "" },
    { TEXT("sphere { 0, 1 camera { } }"), POV_E_SYNTAX, 1, 15,
      "\"camera\" does not belong in \"sphere\"", "" },
    { TEXT("sphere { 0, 1 location 3 }"), POV_E_SYNTAX, 1, 15,
      "\"location\" does not belong in \"sphere\"", "" },
    { TEXT("sphere { 0, 1 pigmnet { rgb 1 } }"), POV_E_SYNTAX, 1, 15,
      "unknown word \"pigmnet\" in \"sphere\"", "pigment" },
    { TEXT("sphere { 0, 1 pigment rgb 1 }"), POV_E_SYNTAX, 1, 23,
      "expected \"{\" after \"pigment\", found \"rgb\"", "" },
    { TEXT("sphere { 0, 1 pigment { rgb } }"), POV_E_SYNTAX, 1, 29,
      "expected a colour after \"rgb\", found \"}\"", "" },
    { TEXT("sphere { 0, 1 pigment { <1, 0, 0> } }"), POV_E_SYNTAX, 1, 25,
      "expected a colour or \"}\" after \"{\", found \"<\"", "" },
    { TEXT("sphere { 0, 1 pigment { .5 } }"), POV_E_SYNTAX, 1, 25,
      "expected a colour or \"}\" after \"{\", found \".5\"", "" },
    { TEXT("sphere { 0, 1 pigment { rgb 1 rgb 0 } }"), POV_E_SYNTAX, 1, 31,
      "\"rgb\" does not belong in \"pigment\"", "" },
    { TEXT("sphere { 0, 1 pigment { rgb <1, 2, 3, 4, 5, 6> } }"), POV_E_SYNTAX, 1, 45,
      "expected \">\" after \",\", found \"6\"", "" },
    { TEXT("sphere { 0, 1 pigment { rgb 1e39 } }"), POV_E_SYNTAX, 1, 29,
      "a number beyond 3.40282e+38 has no use in a colour", "" },
    { TEXT("sphere { 0, 1 pigment { red } }"), POV_E_SYNTAX, 1, 29,
      "expected a number after \"red\", found \"}\"", "" },
    { TEXT("sphere { 0, 1 pigment { red 1e39 } }"), POV_E_SYNTAX, 1, 25,
      "a number beyond 3.40282e+38 has no use in a colour", "" },
    { TEXT("sphere { 0, 1 pigment { colr rgb 1 } }"), POV_E_SYNTAX, 1, 25,
      "unknown word \"colr\" in \"pigment\"", "color" },
    { TEXT("sphere { 0, 1 pigment { White } }"), POV_E_SYNTAX, 1, 25,
      "unknown word \"White\" in \"pigment\"", "" },
    { TEXT("sphere { 0, 1 finish { phong } }"), POV_E_SYNTAX, 1, 30,
      "expected a number after \"phong\", found \"}\"", "" },
    { TEXT("sphere { 0, 1 finish { diffuse rgb 1 } }"), POV_E_SYNTAX, 1, 32,
      "expected a number after \"diffuse\", found \"rgb\"", "" },
    { TEXT("sphere { 0, 1 finish { phong_size -1 } }"), POV_E_SYNTAX, 1, 35,
      "\"phong_size\" must not be negative", "" },
    { TEXT("sphere { 0, 1 finish { difuse .5 } }"), POV_E_SYNTAX, 1, 24,
      "unknown word \"difuse\" in \"finish\"", "diffuse" },
    { TEXT("sphere { 0, 1 finish { reflection } }"), POV_E_SYNTAX, 1, 35,
      "expected a colour after \"reflection\", found \"}\"", "" },
    { TEXT("sphere { 0, 1 interior { ior } }"), POV_E_SYNTAX, 1, 30,
      "expected a number after \"ior\", found \"}\"", "" },
    { TEXT("sphere { 0, 1 interior { ior -1 } }"), POV_E_SYNTAX, 1, 30,
      "\"ior\" must not be negative", "" },
    { TEXT("sphere { 0, 1 interior 1.5 }"), POV_E_SYNTAX, 1, 24,
      "expected \"{\" after \"interior\", found \"1.5\"", "" },
    { TEXT("sphere { 0, 1 no_shadow 1 }"), POV_E_SYNTAX, 1, 25,
      "expected an object modifier or \"}\" after \"no_shadow\", found \"1\"", "" },
    { TEXT("sphere { 0, 1 scale }"), POV_E_SYNTAX, 1, 21,
      "expected a vector after \"scale\", found \"}\"", "" },
    { TEXT("sphere { 0, 1 translate pigment { } }"), POV_E_SYNTAX, 1, 25,
      "expected a vector after \"translate\", found \"pigment\"", "" },
    { TEXT("sphere { 0, 1 rotate \"x\" }"), POV_E_SYNTAX, 1, 22,
      "expected a vector, found a string", "" },
    { TEXT("sphere { 0, 1 matrix 1 }"), POV_E_SYNTAX, 1, 22,
      "expected \"<\" and 12 numbers for a matrix after \"matrix\", found \"1\"", "" },
    { TEXT("sphere { 0, 1 matrix <1, 2, 3> }"), POV_E_SYNTAX, 1, 30,
      "expected a number after \"3\", found \">\"", "" },
    { TEXT("sphere { 0, 1 matrix <1,0,0,1,0,0,0,1,1,0,0,0> }"), POV_E_SYNTAX, 1, 22,
      "the matrix has no inverse", "" },
    { TEXT("cylinder { <0, 0, 0>, <1, 0, 0>, 1 opne }"), POV_E_SYNTAX, 1, 36,
      "unknown word \"opne\" in \"cylinder\"", "open" },
    { TEXT("cylinder { 1, 1, 1 }"), POV_E_SYNTAX, 1, 18,
      "the cylinder has no length", "" },
    { TEXT("cylinder { <0, 0, 0>, <1, 0, 0> }"), POV_E_SYNTAX, 1, 33,
      "expected a number after \">\", found \"}\"", "" },
    { TEXT("polygon { 2, <0, 0>, <1, 0> }"), POV_E_SYNTAX, 1, 11,
      "a polygon has from 3 to a million points", "" },
    { TEXT("polygon { 1e9, <0, 0, 0> }"), POV_E_SYNTAX, 1, 11,
      "a polygon has from 3 to a million points", "" },
    { TEXT("polygon { 4, <0, 0, 0>, <1, 0, 0> }"), POV_E_SYNTAX, 1, 35,
      "expected a vector after \">\", found \"}\"", "" },
    { TEXT("polygon { -1 }"), POV_E_SYNTAX, 1, 11,
      "a polygon has from 3 to a million points", "" },
    { TEXT("quadric { 1, 2, 3 }"), POV_E_SYNTAX, 1, 19,
      "expected a number after \"3\", found \"}\"", "" },
    { TEXT("blob7 { powr 3 (4) }"), POV_E_SYNTAX, 1, 9,
      "expected \"power\" after \"{\", found \"powr\"", "power" },
    { TEXT("blob7 { power 3 [4] }"), POV_E_SYNTAX, 1, 17,
      "expected \"(\" after \"3\", found \"[\"", "" },
    { TEXT("camera { location }"), POV_E_SYNTAX, 1, 19,
      "expected a vector after \"location\", found \"}\"", "" },
    { TEXT("camera { location angle 3 }"), POV_E_SYNTAX, 1, 19,
      "expected a vector after \"location\", found \"angle\"", "" },
    { TEXT("camera { look_at 0 }"), POV_E_SYNTAX, 1, 18,
      "the camera cannot look at its own location", "" },
    { TEXT("camera { location 1\n look_at 1 }"), POV_E_SYNTAX, 2, 10,
      "the camera cannot look at its own location", "" },
    { TEXT("camera { angle 0 }"), POV_E_SYNTAX, 1, 16,
      "the angle of a camera lies between 0 and 180 degrees", "" },
    { TEXT("camera { angle -40 }"), POV_E_SYNTAX, 1, 16,
      "the angle of a camera lies between 0 and 180 degrees", "" },
    { TEXT("camera { angle 180 }"), POV_E_SYNTAX, 1, 16,
      "the angle of a camera lies between 0 and 180 degrees", "" },
    { TEXT("camera { angle <1, 2, 3> }"), POV_E_SYNTAX, 1, 23,
      "expected a number, found a vector", "" },
    { TEXT("camera { right 0 }"), POV_E_SYNTAX, 1, 16,
      "\"right\" must not be zero", "" },
    { TEXT("camera { up <0, 0, 0> }"), POV_E_SYNTAX, 1, 13,
      "\"up\" must not be zero", "" },
    { TEXT("camera { direction 0 }"), POV_E_SYNTAX, 1, 20,
      "\"direction\" must not be zero", "" },
    { TEXT("camera { locatoin 0 }"), POV_E_SYNTAX, 1, 10,
      "unknown word \"locatoin\" in \"camera\"", "location" },
    { TEXT("camera { sphere { 0, 1 } }"), POV_E_SYNTAX, 1, 10,
      "\"sphere\" does not belong in \"camera\"", "" },
    { TEXT("camera 5"), POV_E_SYNTAX, 1, 8,
      "expected \"{\" after \"camera\", found \"5\"", "" },
    { TEXT("camera { scale 1e308 location <1e10, 0, 0> }"), POV_E_SYNTAX, 1, 1,
      "the camera is moved beyond what a double holds", "" },
    { TEXT("light_source { }"), POV_E_SYNTAX, 1, 16,
      "expected a vector after \"{\", found \"}\"", "" },
    { TEXT("light_source { rgb 1 }"), POV_E_SYNTAX, 1, 16,
      "expected a vector after \"{\", found \"rgb\"", "" },
    { TEXT("light_source { 0, translate 1 rgb 1 }"), POV_E_SYNTAX, 1, 31,
      "\"rgb\" does not belong in \"light_source\"", "" },
    { TEXT("light_source { 0 rgb 1 radius 5 spotlight }"), POV_E_SYNTAX, 1, 24,
      "\"radius\" stands behind \"spotlight\" or \"cylinder\"", "" },
    { TEXT("light_source { 0 rgb 1 point_at 1 }"), POV_E_SYNTAX, 1, 24,
      "\"point_at\" stands behind \"spotlight\", \"cylinder\" or \"parallel\"", "" },
    { TEXT("light_source { 0 rgb 1 area_light x, y, 0, 1 }"), POV_E_SYNTAX, 1, 41,
      "an area light has 1 to 16384 points a side", "" },
    { TEXT("light_source { <1e308, 0, 0>, rgb 1 scale 1e10 }"), POV_E_SYNTAX, 1, 1,
      "the light is moved beyond what a double holds", "" },
    { TEXT("global_settings { max_trace_level -1 }"), POV_E_SYNTAX, 1, 35,
      "\"max_trace_level\" must lie in 0 to 65535", "" },
    { TEXT("global_settings { max_trace_level 1e9 }"), POV_E_SYNTAX, 1, 35,
      "\"max_trace_level\" must lie in 0 to 65535", "" },
    { TEXT("global_settings { assumed_gamma 0 }"), POV_E_SYNTAX, 1, 33,
      "\"assumed_gamma\" must be above 0", "" },
    { TEXT("global_settings { ambient_ligth 1 }"), POV_E_SYNTAX, 1, 19,
      "unknown word \"ambient_ligth\" in \"global_settings\"", "ambient_light" },
    { TEXT("global_settings"), POV_E_SYNTAX, 1, 16,
      "expected \"{\" after \"global_settings\", found the end of the text", "" },
    { TEXT("background { }}"), POV_E_SYNTAX, 1, 15,
      "expected an object or a setting after \"}\", found \"}\"", "" },
    { TEXT("background { rgb }"), POV_E_SYNTAX, 1, 18,
      "expected a colour after \"rgb\", found \"}\"", "" },
    { TEXT("background { rgb 1 rgb 0 }"), POV_E_SYNTAX, 1, 20,
      "\"rgb\" does not belong in \"background\"", "" },
    { TEXT("background { pigment { rgb 1 } }"), POV_E_SYNTAX, 1, 14,
      "expected a colour after \"{\", found \"pigment\"", "" },
    { TEXT("translate 3"), POV_E_SYNTAX, 1, 1,
      "\"translate\" does not belong at the top level", "" },
    { TEXT("#"), POV_E_SYNTAX, 1, 2,
      "expected a directive after \"#\", found the end of the text", "" },
    { TEXT("#versoin 3.7;"), POV_E_SYNTAX, 1, 1,
      "unknown directive \"#versoin\"", "version" },
    { TEXT("#nonsense"), POV_E_SYNTAX, 1, 1,
      "unknown directive \"#nonsense\"", "" },
    { TEXT("#version"), POV_E_SYNTAX, 1, 9,
      "expected a number after \"version\", found the end of the text", "" },
    { TEXT("#version \"3.7\";"), POV_E_SYNTAX, 1, 10,
      "expected a number, found a string", "" },
    { TEXT("#version 3.7 3.6;"), POV_E_SYNTAX, 1, 14,
      "expected an object or a setting, found \"3.6\"", "" },
    { TEXT("# 5"), POV_E_SYNTAX, 1, 3,
      "expected a directive after \"#\", found \"5\"", "" },
    { TEXT("sphere #version 3.7; { 0, 1 oops }"), POV_E_SYNTAX, 1, 29,
      "unknown word \"oops\" in \"sphere\"", "" },
    { TEXT("camera #version 3.7; { angle 40"), POV_E_SYNTAX, 1, 32,
      "expected an item of the camera or \"}\" after \"40\", found the end of the text;"
      " the \"{\" of \"camera\" at 1:22 is still open", "" },
    { TEXT("sphere { \303\251, 1 }"), POV_E_SYNTAX, 1, 10,
      "\"\303\251\" does not belong outside of comments and strings", "" },
    { TEXT("sphere { \351, 1 }"), POV_E_SYNTAX, 1, 10,
      "the byte 0xE9 does not belong outside of comments and strings", "" },
    { TEXT("sph\303\251re { 0, 1 }"), POV_E_SYNTAX, 1, 1,
      "unknown word \"sph\"", "" },
    { TEXT("sphere { 0, 1 } @"), POV_E_SYNTAX, 1, 17,
      "\"@\" does not belong outside of comments and strings", "" },
    { TEXT("sphere { 0, 1 } $x"), POV_E_SYNTAX, 1, 17,
      "\"$\" does not belong outside of comments and strings", "" },
    { TEXT("sphere { 0, \"1 }"), POV_E_SYNTAX, 1, 13,
      "the string that begins here has no end", "" },
    { TEXT("\"never ends"), POV_E_SYNTAX, 1, 1,
      "the string that begins here has no end", "" },
    { TEXT("\377\376s\000p\000"), POV_E_SYNTAX, 1, 1,
      "this text is in UTF-16; save it as UTF-8", "" },
    { TEXT("\376\377\000s\000p"), POV_E_SYNTAX, 1, 1,
      "this text is in UTF-16; save it as UTF-8", "" },
    { TEXT("s\000p\000h\000"), POV_E_SYNTAX, 1, 1,
      "this text is in UTF-16; save it as UTF-8", "" },
    { TEXT("\211PNG\r\n\032\n\000\000\000\rIHDR"), POV_E_SYNTAX, 3, 1,
      "a zero byte: this is not a text", "" },
    { TEXT("sphere { 0, 1 }\n\000"), POV_E_SYNTAX, 2, 1,
      "a zero byte: this is not a text", "" },
    { TEXT("\177ELF\002\001\001\000\000"), POV_E_SYNTAX, 1, 8,
      "a zero byte: this is not a text", "" },
    { TEXT("#declare X = 3"), POV_E_SYNTAX, 1, 15,
      "expected \";\" after \"3\", found the end of the text", "" },
    { TEXT("#declare sphere = 3;"), POV_E_SYNTAX, 1, 10,
      "\"sphere\" is a word of the language, and no name", "" },
    { TEXT("#declare 3 = 3;"), POV_E_SYNTAX, 1, 10,
      "expected a name after \"declare\", found \"3\"", "" },
    { TEXT("#declare X = Radus; #declare Radius = 1;"), POV_E_SYNTAX, 1, 14,
      "\"Radus\" is not declared", "" },
    { TEXT("#declare Radius = 1; sphere { 0, 1 scale Radus }"), POV_E_SYNTAX, 1, 42,
      "\"Radus\" is not declared", "Radius" },
    { TEXT("#if (1)"), POV_E_SYNTAX, 1, 1,
      "there is no \"#end\" for this", "" },
    { TEXT("#if (0) sphere"), POV_E_SYNTAX, 1, 1,
      "there is no \"#end\" for this", "" },
    { TEXT("#while (1)"), POV_E_SYNTAX, 1, 1,
      "there is no \"#end\" for this", "" },
    { TEXT("sphere { 0, 1 } #end"), POV_E_SYNTAX, 1, 17,
      "there is nothing open that this \"#end\" belongs to", "" },
    { TEXT("sphere { 0, 1 } #else"), POV_E_SYNTAX, 1, 17,
      "there is nothing open that this \"#else\" belongs to", "" },
    { TEXT("#if (1) #else #else #end"), POV_E_SYNTAX, 1, 16,
      "a second \"#else\"", "" },
    { TEXT("#break"), POV_E_SYNTAX, 1, 1,
      "there is nothing that this \"#break\" could leave", "" },
    { TEXT("#for (I, 1, 2, 0) #end"), POV_E_SYNTAX, 1, 16,
      "the step of a loop is not 0", "" },
    { TEXT("#macro M(A) A #end sphere { 0, M() }"), POV_E_SYNTAX, 1, 34,
      "\"M\" wants 1 argument, found 0", "" },
    { TEXT("#macro M(A) A #end sphere { 0, M(1, 2) }"), POV_E_SYNTAX, 1, 37,
      "expected \")\" after \",\", found \"2\"", "" },
    { TEXT("#macro M() M() #end M()"), POV_E_SYNTAX, 1, 12,
      "more than 1200 macros and include files within each other", "" },
    { TEXT("#declare A = array[2] {1, 2}; sphere { 0, A[2] }"), POV_E_SYNTAX, 1, 45,
      "the subscript 2 lies outside of 0 to 1", "" },
    { TEXT("#declare A = array[2]; sphere { 0, A[1] }"), POV_E_SYNTAX, 1, 36,
      "this element of \"A\" has no value yet", "" },
    { TEXT("#declare A = array[2] {1, x};"), POV_E_SYNTAX, 1, 27,
      "all elements of an array are of one kind: a number, not a vector", "" },
    { TEXT("#include \"no such file\""), POV_E_IO, 1, 10,
      "there is no file \"no such file\" in the folders that scenes are read from", "" },
    { TEXT("#error concat(\"a\", \"b\")"), POV_E_SYNTAX, 1, 1,
      "the scene says: ab", "" },
    { TEXT("sphere { 0, sqrt(-1) }"), POV_E_SYNTAX, 1, 18,
      "the root of -1", "" },
    { TEXT("sphere { 0, 1/0 }"), POV_E_SYNTAX, 1, 13,
      "inf is no number that can stand here", "" },
    { TEXT("sphere { 0, 1 scale \"a\" + 1 }"), POV_E_SYNTAX, 1, 21,
      "expected a vector, found a string", "" },
    { TEXT("sphere { 0, x.transmit }"), POV_E_SYNTAX, 1, 15,
      "a vector of 3 has no component \"transmit\"", "" },
    { TEXT("#declare A = 1 +;"), POV_E_SYNTAX, 1, 17,
      "expected a value after \"+\", found \";\"", "" },
    { TEXT("#declare A = (1;"), POV_E_SYNTAX, 1, 16,
      "expected \")\" after \"1\", found \";\"", "" },
    { TEXT("#declare A = <1>;"), POV_E_SYNTAX, 1, 16,
      "expected a number after \"1\", found \">\"", "" },
    { TEXT("#declare A = <1, 2, 3, 4, 5, 6>;"), POV_E_SYNTAX, 1, 30,
      "expected \">\" after \",\", found \"6\"", "" },
    { TEXT("#declare A = <1, <2, 3>, 4>;"), POV_E_SYNTAX, 1, 22,
      "expected a number, found a vector", "" },
    { TEXT("#declare A = 1.5.5;"), POV_E_SYNTAX, 1, 14,
      "\"1.5.5\" is not a number", "" },
    { TEXT("#declare A = max();"), POV_E_SYNTAX, 1, 18,
      "expected a number after \"(\", found \")\"", "" },
    { TEXT("#declare A = sin(1, 2);"), POV_E_SYNTAX, 1, 19,
      "expected \")\" after \"1\", found \",\"", "" },
    { TEXT("#declare A = atan2(0, 0);"), POV_E_SYNTAX, 1, 23,
      "the angle of a vector without length", "" },
    { TEXT("#declare A = ln(0);"), POV_E_SYNTAX, 1, 17,
      "\"ln\" is of numbers above 0", "" },
    { TEXT("#declare A = pow(0, 0);"), POV_E_SYNTAX, 1, 21,
      "0 to the power of 0", "" },
    { TEXT("#declare A = vlength(<1, 2, 3, 4>);"), POV_E_SYNTAX, 1, 32,
      "expected a vector, found one of 4 components", "" },
    { TEXT("#declare A = vcross(x);"), POV_E_SYNTAX, 1, 22,
      "expected a vector after \"x\", found \")\"", "" },
    { TEXT("#declare A = \"a\" \"b\";"), POV_E_SYNTAX, 1, 18,
      "expected an object or a setting, found the string \"b\"", "" },
    { TEXT("#declare A = \"\\q\";"), POV_E_SYNTAX, 1, 15,
      "there is no such escape in strings", "" },
    { TEXT("#declare A = concat();"), POV_E_SYNTAX, 1, 21,
      "expected a value after \"(\", found \")\"", "" },
    { TEXT("#declare A = concat(\"a\", 1);"), POV_E_SYNTAX, 1, 26,
      "expected a string, found a number", "" },
    { TEXT("#declare A = chr(70000);"), POV_E_SYNTAX, 1, 18,
      "a character has a number from 0 to 65535", "" },
    { TEXT("#declare A = substr(\"abc\", 2, 5);"), POV_E_SYNTAX, 1, 31,
      "the string has only 3 characters", "" },
    { TEXT("#declare A = str(1, 2);"), POV_E_SYNTAX, 1, 22,
      "expected a number after \"2\", found \")\"", "" },
    { TEXT("#declare A = strlen(1);"), POV_E_SYNTAX, 1, 21,
      "expected a string, found a number", "" },
    { TEXT("#declare A = rand(0);"), POV_E_SYNTAX, 1, 19,
      "0 is no stream of random numbers, which seed() gives", "" },
    { TEXT("#declare A = dimension_size(1, 1);"), POV_E_SYNTAX, 1, 29,
      "expected an array, found a number", "" },
    { TEXT("#declare A = x.red.red.y;"), POV_E_SYNTAX, 1, 24,
      "a number has no component \"y\"", "" },
    { TEXT("#declare A = 5; #declare B = A.y;"), POV_E_SYNTAX, 1, 32,
      "a number has no component \"y\"", "" },
    { TEXT("#declare A = -\"a\";"), POV_E_SYNTAX, 1, 14,
      "expected a number or a vector behind the sign, found a string", "" },
    { TEXT("#declare A = (x ? 1 : 2);"), POV_E_SYNTAX, 1, 15,
      "expected a number, found a vector", "" },
    { TEXT("#declare A = (1 ? 2);"), POV_E_SYNTAX, 1, 20,
      "expected \":\" after \"2\", found \")\"", "" },
    { TEXT("#if (x) #end"), POV_E_SYNTAX, 1, 6,
      "expected a number, found a vector", "" },
    { TEXT("#if (\"a\") #end"), POV_E_SYNTAX, 1, 6,
      "expected a number, found a string", "" },
    { TEXT("#if 1 #end"), POV_E_SYNTAX, 1, 5,
      "expected \"(\" after \"if\", found \"1\"", "" },
    { TEXT("#if (1"), POV_E_SYNTAX, 1, 7,
      "expected \")\" after \"1\", found the end of the text", "" },
    { TEXT("#ifdef A #end"), POV_E_SYNTAX, 1, 8,
      "expected \"(\" after \"ifdef\", found \"A\"", "" },
    { TEXT("#ifdef (A.x) #end"), POV_E_SYNTAX, 1, 10,
      "expected \")\" after \"A\", found \".\"", "" },
    { TEXT("#switch (\"a\") #case (1) #end"), POV_E_SYNTAX, 1, 10,
      "expected a number, found a string", "" },
    { TEXT("#switch (1) #case (1)"), POV_E_SYNTAX, 1, 1,
      "there is no \"#end\" for this", "" },
    { TEXT("#case (1)"), POV_E_SYNTAX, 1, 1,
      "there is nothing open that this \"#case\" belongs to", "" },
    { TEXT("#range (1, 2)"), POV_E_SYNTAX, 1, 1,
      "there is nothing open that this \"#range\" belongs to", "" },
    { TEXT("#if (1) #case (1) #end"), POV_E_SYNTAX, 1, 9,
      "there is nothing open that this \"#case\" belongs to", "" },
    { TEXT("#elseif (1)"), POV_E_SYNTAX, 1, 1,
      "there is nothing open that this \"#elseif\" belongs to", "" },
    { TEXT("#while (1 #end"), POV_E_SYNTAX, 1, 12,
      "expected \")\" after \"#\", found \"end\"", "" },
    { TEXT("#for (I, 1) #end"), POV_E_SYNTAX, 1, 11,
      "expected a number after \"1\", found \")\"", "" },
    { TEXT("#for (1, 2, 3) #end"), POV_E_SYNTAX, 1, 7,
      "expected the name of a variable after \"(\", found \"1\"", "" },
    { TEXT("#for (x, 2, 3) #end"), POV_E_SYNTAX, 1, 7,
      "expected the name of a variable after \"(\", found \"x\"", "" },
    { TEXT("#macro"), POV_E_SYNTAX, 1, 7,
      "expected the name of a macro after \"macro\", found the end of the text", "" },
    { TEXT("#macro M"), POV_E_SYNTAX, 1, 9,
      "expected \"(\" after \"M\", found the end of the text", "" },
    { TEXT("#macro M() 1"), POV_E_SYNTAX, 1, 1,
      "there is no \"#end\" for this", "" },
    { TEXT("#macro x() 1 #end"), POV_E_SYNTAX, 1, 8,
      "expected the name of a macro after \"macro\", found \"x\"", "" },
    { TEXT("#macro M(x) 1 #end"), POV_E_SYNTAX, 1, 10,
      "expected the name of a parameter after \"(\", found \"x\"", "" },
    { TEXT("#macro M(A B #end"), POV_E_SYNTAX, 1, 14,
      "there is nothing open that this \"#end\" belongs to", "" },
    { TEXT("#declare M = 1; #macro M() 2 #end"), POV_E_SYNTAX, 1, 24,
      "\"M\" is a number already", "" },
    { TEXT("#macro M() 1 #end #declare M = 2;"), POV_E_SYNTAX, 1, 28,
      "\"M\" is a macro; \"#undef M\" makes the name free", "" },
    { TEXT("#macro M() 1 #end #declare A = M;"), POV_E_SYNTAX, 1, 33,
      "expected \"(\" after \"M\", found \";\"", "" },
    { TEXT("#macro M(A) A #end #declare B = M(Nobody);"), POV_E_SYNTAX, 1, 35,
      "\"Nobody\" is not declared", "" },
    { TEXT("#macro M(A, B) A #end #declare C = M(1);"), POV_E_SYNTAX, 1, 39,
      "\"M\" wants 2 arguments, found 1", "" },
    { TEXT("#undef"), POV_E_SYNTAX, 1, 7,
      "expected a name after \"undef\", found the end of the text", "" },
    { TEXT("#undef 5"), POV_E_SYNTAX, 1, 8,
      "expected a name after \"undef\", found \"5\"", "" },
    { TEXT("#declare A = array;"), POV_E_SYNTAX, 1, 19,
      "expected \"[\" and the size of the array after \"array\", found \";\"", "" },
    { TEXT("#declare A = array[0];"), POV_E_SYNTAX, 1, 20,
      "an array has at least one element", "" },
    { TEXT("#declare A = array[-1];"), POV_E_SYNTAX, 1, 20,
      "an array has at least one element", "" },
    { TEXT("#declare A = array[1][1][1][1][1][1];"), POV_E_SYNTAX, 1, 35,
      "an array has at most 5 dimensions", "" },
    { TEXT("#declare A = array[3] { 1, 2 };"), POV_E_SYNTAX, 1, 30,
      "expected a value after \"2\", found \"}\"", "" },
    { TEXT("#declare A = array[2] { 1, 2, 3 };"), POV_E_SYNTAX, 1, 31,
      "expected \"}\" after \",\", found \"3\"", "" },
    { TEXT("#declare A = array[2][2] { 1, 2, 3, 4 };"), POV_E_SYNTAX, 1, 28,
      "expected \"{\" after \"{\", found \"1\"", "" },
    { TEXT("#declare A = array[2] { 1, \"a\" };"), POV_E_SYNTAX, 1, 28,
      "all elements of an array are of one kind: a number, not a string", "" },
    { TEXT("#declare A = array[2][2] { {1, 2}, {3, 4} }; #declare B = A[0];"), POV_E_SYNTAX, 1, 63,
      "expected \"[\" after \"]\", found \";\"", "" },
    { TEXT("#declare A = array[2] { 1, 2 }; #declare A[2] = 1;"), POV_E_SYNTAX, 1, 44,
      "the subscript 2 lies outside of 0 to 1", "" },
    { TEXT("#declare A = array[2] { 1, 2 }; #declare B = A[0][0];"), POV_E_SYNTAX, 1, 50,
      "expected \";\" after \"]\", found \"[\"", "" },
    { TEXT("#declare A = 1; #declare A[0] = 1;"), POV_E_SYNTAX, 1, 27,
      "expected \"=\" after \"A\", found \"[\"", "" },
    { TEXT("#include"), POV_E_SYNTAX, 1, 9,
      "expected a value after \"include\", found the end of the text", "" },
    { TEXT("#include 5"), POV_E_SYNTAX, 1, 10,
      "expected a string, found a number", "" },
    { TEXT("#debug 5"), POV_E_SYNTAX, 1, 8,
      "expected a string, found a number", "" },
    { TEXT("#error \"stop\""), POV_E_SYNTAX, 1, 1,
      "the scene says: stop", "" },
    { TEXT("#fopen 5 \"f\" read"), POV_E_SYNTAX, 1, 8,
      "expected a name for the file after \"fopen\", found \"5\"", "" },
    { TEXT("#fopen F \"f.txt\" sideways"), POV_E_SYNTAX, 1, 18,
      "expected \"read\", \"write\" or \"append\" after \"\"f.txt\"\", found \"sideways\"", "" },
    { TEXT("#declare F = 1; #fopen F \"f.txt\" write"), POV_E_SYNTAX, 1, 24,
      "\"F\" is a number already", "" },
    { TEXT("#read (F, A)"), POV_E_SYNTAX, 1, 8,
      "expected the name of an open file after \"(\", found \"F\"", "" },
    { TEXT("#write (F, 1)"), POV_E_SYNTAX, 1, 9,
      "expected the name of an open file after \"(\", found \"F\"", "" },
    { TEXT("#fopen F \"f.txt\" write #write (F, rgb 1)"), POV_E_SYNTAX, 1, 35,
      "expected a number, a vector or a string after \",\", found \"rgb\"", "" },
    { TEXT("#fopen F \"f.txt\" write #read (F, A)"), POV_E_SYNTAX, 1, 24,
      "the file is open for writing", "" },
    { TEXT("#default { sphere { 0, 1 } }"), POV_E_SYNTAX, 1, 12,
      "\"sphere\" does not belong in \"default\"", "" },
    { TEXT("#default"), POV_E_SYNTAX, 1, 9,
      "expected \"{\" after \"default\", found the end of the text", "" },
    { TEXT("#version \"a\";"), POV_E_SYNTAX, 1, 10,
      "expected a number, found a string", "" },
    { TEXT("#declare F = function { };"), POV_E_SYNTAX, 1, 25,
      "expected a number after \"{\", found \"}\"", "" },
    { TEXT("#declare F = function { x + };"), POV_E_SYNTAX, 1, 29,
      "expected a number after \"+\", found \"}\"", "" },
    { TEXT("#declare F = function { x ? 1 : 2 };"), POV_E_SYNTAX, 1, 27,
      "expected \"}\" after \"x\", found \"?\"", "" },
    { TEXT("#declare F = function { !x };"), POV_E_SYNTAX, 1, 25,
      "expected a number after \"{\", found \"!\"", "" },
    { TEXT("#declare F = function (a) { b };"), POV_E_SYNTAX, 1, 29,
      "\"b\" is not declared", "" },
    { TEXT("#declare F = function () { 1 };"), POV_E_SYNTAX, 1, 24,
      "expected the name of a parameter after \"(\", found \")\"", "" },
    { TEXT("#declare F = function (x) { F(x) };"), POV_E_SYNTAX, 1, 29,
      "\"F\" is being declared: a function cannot call itself", "" },
    { TEXT("#declare F = function (sphere) { 1 };"), POV_E_SYNTAX, 1, 24,
      "expected the name of a parameter after \"(\", found \"sphere\"", "" },
    { TEXT("#declare F = function { x }; #declare F = 1;"), POV_E_SYNTAX, 1, 39,
      "\"F\" is a function; \"#undef F\" makes the name free", "" },
    { TEXT("#declare F = function { x }; #declare A = F(1);"), POV_E_SYNTAX, 1, 46,
      "expected a number after \"1\", found \")\"", "" },
    { TEXT("#declare F = function { x }; #declare A = F(1, 2, 3, 4);"), POV_E_SYNTAX, 1, 52,
      "expected \")\" after \"3\", found \",\"", "" },
    { TEXT("#declare F = function { x.y };"), POV_E_SYNTAX, 1, 26,
      "expected \"}\" after \"x\", found \".\"", "" },
    { TEXT("#declare F = function { rand(x) };"), POV_E_SYNTAX, 1, 25,
      "expected a number or a function of numbers after \"{\", found \"rand\"", "" },
    { TEXT("#declare F = function { \"a\" };"), POV_E_SYNTAX, 1, 25,
      "expected a number after \"{\", found the string \"a\"", "" },
    { TEXT("#declare F = function { sum(i, 1) };"), POV_E_SYNTAX, 1, 33,
      "expected \",\" after \"1\", found \")\"", "" },
    { TEXT("#declare F = function { internal(99) };"), POV_E_SYNTAX, 1, 34,
      "there is no internal function 99", "" },
    { TEXT("#declare S = spline { };"), POV_E_SYNTAX, 1, 23,
      "expected the first point of the spline after \"{\", found \"}\"", "" },
    { TEXT("#declare S = spline { 0 };"), POV_E_SYNTAX, 1, 25,
      "expected a value after \"0\", found \"}\"", "" },
    { TEXT("#declare S = spline { 0, x } #declare A = S(0, 5);"), POV_E_SYNTAX, 1, 48,
      "expected a type of spline after \",\", found \"5\"", "" },
    { TEXT("#declare T = transform { sphere { 0, 1 } }"), POV_E_SYNTAX, 1, 26,
      "\"sphere\" does not belong in \"transform\"", "" },
    { TEXT("#declare T = transform { matrix <1, 2, 3> }"), POV_E_SYNTAX, 1, 41,
      "expected a number after \"3\", found \">\"", "" },
    { TEXT("#declare T = 5; sphere { 0, 1 transform T }"), POV_E_SYNTAX, 1, 41,
      "expected \"{\" after \"transform\", found \"T\"", "" },
    { TEXT("#declare T = texture { } sphere { 0, 1 pigment { T } }"), POV_E_SYNTAX, 1, 50,
      "\"T\" is a texture, which does not belong in \"pigment\"", "" },
    { TEXT("#declare P = pigment { rgb 1 } sphere { 0, 1 pigment P }"), POV_E_SYNTAX, 1, 54,
      "expected \"{\" after \"pigment\", found \"P\"", "" },
    { TEXT("#declare L = 5; object { L }"), POV_E_SYNTAX, 1, 26,
      "expected an object after \"{\", found \"L\"", "" },
    { TEXT("object { }"), POV_E_SYNTAX, 1, 10,
      "expected an object after \"{\", found \"}\"", "" },
    { TEXT("object { Nobody }"), POV_E_SYNTAX, 1, 10,
      "expected an object after \"{\", found \"Nobody\"", "" },
    { TEXT("union { translate x sphere { 0, 1 } }"), POV_E_SYNTAX, 1, 21,
      "\"sphere\" does not belong in \"union\"", "" },
    { TEXT("sphere { 0, 1 translate }"), POV_E_SYNTAX, 1, 25,
      "expected a vector after \"translate\", found \"}\"", "" },
    { TEXT("sphere { 0, 1 rotate \"a\" }"), POV_E_SYNTAX, 1, 22,
      "expected a vector, found a string", "" },
    { TEXT("sphere { 0, 1 pigment { color_map { } } }"), POV_E_SYNTAX, 1, 37,
      "expected \"[\" and the first entry of the map after \"{\", found \"}\"", "" },
    { TEXT("sphere { 0, 1 pigment { rgb x color_map { [0 rgb y] } } }"), POV_E_SYNTAX, 1, 53,
      "a map needs a pattern that chooses from it, and this pigment is one colour", "" },
    { TEXT("sphere { 0, 1 pigment { color_map { [0] } } }"), POV_E_SYNTAX, 1, 39,
      "expected a colour after \"0\", found \"]\"", "" },
    { TEXT("sphere { 0, 1 finish { phong 1, ambient 0 } }"), POV_E_SYNTAX, 1, 31,
      "expected an item of the finish or \"}\" after \"1\", found \",\"", "" },
    { TEXT("#declare N = 1; #declare S = sphere { 0, 1 } #declare A = trace(S, 0, x, N);"), POV_E_SYNTAX, 1, 74,
      "expected the name of a vector after \",\", found \"N\"", "" },
    { TEXT("#declare A = inside(5, x);"), POV_E_SYNTAX, 1, 21,
      "expected the name of an object, found a number", "" },
    { TEXT("#declare A = min_extent(x);"), POV_E_SYNTAX, 1, 25,
      "expected the name of an object, found a vector", "" },
    { TEXT("declare A = 1"), POV_E_SYNTAX, 1, 14,
      "expected \";\" after \"1\", found the end of the text", "" },
    { TEXT("local A = 1;"), POV_E_SYNTAX, 1, 1,
      "\"local\" does not belong at the top level", "" },
    { TEXT("<1, 2, 3>"), POV_E_SYNTAX, 1, 1,
      "expected an object or a setting, found \"<\"", "" },
    { TEXT("light_source { 0, \"a\" }"), POV_E_SYNTAX, 1, 19,
      "expected a modifier of the light or \"}\" after \",\", found the string \"a\"", "" },
    { TEXT("\t\tsphere { 0, 1 pigmnt { } }"), POV_E_SYNTAX, 1, 17,
      "unknown word \"pigmnt\" in \"sphere\"", "pigment" },
    { TEXT("sphere { 0, 1 }\r\n\r\nsphere { 0, 1 oops }"), POV_E_SYNTAX, 3, 15,
      "unknown word \"oops\" in \"sphere\"", "" },
    { TEXT("sphere { 0, 1 }\rsphere { 0, 1 oops }"), POV_E_SYNTAX, 2, 15,
      "unknown word \"oops\" in \"sphere\"", "" },
};

/* A block of exactly the text's size, so that the sanitizers see a read beyond its end. */
static void begin_exact(reading *r, const char *text, size_t length)
{
    char *exact = malloc(length ? length : 1);

    assert_non_null(exact);
    memcpy(exact, text, length);
    reading_begin_bytes(r, exact, length, NULL, NULL);
    free(exact);
}

static void every_wrong_text_is_refused_with_its_place(void **state)
{
    size_t i, wrong = 0;

    (void)state;
    assert_true(sizeof cases / sizeof cases[0] >= 80);
    for (i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const malformed *c = &cases[i];
        reading r;

        begin_exact(&r, c->text, c->length);
        if (r.status != c->status || r.error.status != c->status || r.error.line != c->line ||
            r.error.column != c->column || strcmp(r.error.message, c->message) != 0 ||
            strcmp(r.error.hint, c->hint) != 0 || strcmp(r.error.file, "scene.pov") != 0) {
            print_error("%s\n    gave %d at %d:%d %s [%s]\n", c->text, r.status, r.error.line, r.error.column,
                        r.error.message, r.error.hint);
            wrong++;
        }
        assert_true(r.error.caret <= (int)strlen(r.error.excerpt));
        reading_end(&r);
    }
    assert_int_equal(wrong, 0);
}

/* ---- the same within macros ---- */

static bool is_note(const reading *r, int i, const char *message, int line)
{
    return strcmp(r->notes[i].message, message) == 0 && r->notes[i].line == line;
}


static bool is_told_with_its_callers(const malformed *c)
{
    static const char head[] = "#macro In()\n", tail[] = "\n#end\n#macro Out() In() #end\nOut()";
    const size_t length = sizeof head - 1 + c->length + sizeof tail - 1;
    char *text = malloc(length);
    bool is_told;
    int lines = 0;
    reading r;

    assert_non_null(text);
    memcpy(text, head, sizeof head - 1);
    memcpy(text + sizeof head - 1, c->text, c->length);
    memcpy(text + sizeof head - 1 + c->length, tail, sizeof tail - 1);
    for (size_t i = 0; i < c->length; i++)
        lines += c->text[i] == '\n';
    begin_exact(&r, text, length);
    is_told = r.status == c->status && r.error.line == c->line + 1 && r.error.column == c->column && r.note_count == 2 &&
              is_note(&r, 0, "in the macro \"In\", called here", lines + 4) &&
              is_note(&r, 1, "in the macro \"Out\", called here", lines + 5);
    reading_end(&r);
    free(text);
    return is_told;
}

static void texts_in_macros_are_refused_with_their_callers(void **state)
{
    size_t i, told = 0;

    (void)state;
    for (i = 0; i < sizeof cases / sizeof cases[0]; i++)
        told += is_told_with_its_callers(&cases[i]);
    if (told < TOLD_IN_MACROS)
        fail_msg("%zu of %zu", told, sizeof cases / sizeof cases[0]);
}

/* ---- sizes that break weak readers ---- */

static void refused_at(const char *text, size_t length, int line, int column)
{
    reading r;

    begin_exact(&r, text, length);
    assert_int_equal(r.status, POV_E_SYNTAX);
    assert_int_equal(r.error.line, line);
    assert_int_equal(r.error.column, column);
    reading_end(&r);
}

static void ten_thousand_nested_braces_are_refused(void **state)
{
    static char text[8 + 10000];

    (void)state;
    memcpy(text, "sphere {", 8);
    memset(text + 8, '{', 10000);
    refused_at(text, sizeof text, 1, 9);
    memset(text, '{', sizeof text);
    refused_at(text, sizeof text, 1, 1);
}

static void a_million_nested_comments_are_one_without_an_end(void **state)
{
    char *text = malloc(2000000);
    size_t i;

    (void)state;
    assert_non_null(text);
    for (i = 0; i < 2000000; i += 2)
        memcpy(text + i, "/*", 2);
    refused_at(text, 2000000, 1, 1);
    free(text);
}

static void a_hundred_thousand_directives_and_signs_go_no_deeper(void **state)
{
    char *text = malloc(1300000);
    reading r;
    size_t i;

    (void)state;
    assert_non_null(text);
    for (i = 0; i < 1300000; i += 13)
        memcpy(text + i, "#version 3.1 ", 13);
    begin_exact(&r, text, 1300000);
    assert_int_equal(r.status, POV_OK);
    reading_end(&r);
    memset(text, '-', 1300000);
    memcpy(text, "sphere {", 8);
    refused_at(text, 1300000, 1, 1300001);
    free(text);
}

/* What stands within itself again and again is refused before the reader's own calls fill the stack. */
static void text_within_text_goes_only_so_deep(void **state)
{
    static const char *const starts[] = {
        "#declare A = (", "#declare A = <1, ", "union {", "#declare F = function { (", "#declare A = #declare A =",
        "#macro S() #local I = 0; #while (I < (1) #local I = I+1; #end #end S()", "sphere { 0, 1 transform {",
        "sphere { 0, 1 pigment { average pigment_map { [1 pigment {", "#declare A = array[1] { ", "#declare A = max(",
    };
    enum { TIMES = 20000 };
    size_t i, j;

    (void)state;
    for (i = 0; i < sizeof starts / sizeof starts[0]; i++) {
        const char *last = strrchr(starts[i], ' ');
        const char *again = i == 4 ? "#declare A =" : i == 2 ? "union {" : i == 6 ? "transform {" : last + 1;
        const size_t length = strlen(starts[i]), more = strlen(again), size = length + TIMES * more;
        char *text = malloc(size + 1);
        reading r;

        assert_non_null(text);
        strcpy(text, starts[i]);
        for (j = 0; j < TIMES; j++)
            memcpy(text + length + j * more, again, more);
        reading_begin_bytes(&r, text, size, NULL, NULL);
        assert_int_equal(r.status, POV_E_SYNTAX);
        reading_end(&r);
        free(text);
    }
}

static void long_words_and_lines_are_shown_in_part(void **state)
{
    static char text[100000];
    reading r;

    (void)state;
    memset(text, ' ', sizeof text);
    memset(text + 50000, 'q', 20000);
    begin_exact(&r, text, sizeof text);
    assert_int_equal(r.error.column, 50001);
    assert_string_equal(r.error.message, "unknown word \"qqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqqq...\"");
    assert_int_equal(r.error.excerpt[r.error.caret], 'q');
    assert_int_equal(r.error.excerpt[r.error.caret - 1], ' ');
    assert_int_equal(strlen(r.error.excerpt), sizeof r.error.excerpt - 1);
    reading_end(&r);
}

static void what_a_terminal_would_obey_is_not_shown(void **state)
{
    reading r;

    (void)state;
    begin_exact(&r, TEXT("/* \033[2J \302\233 \303\251 */ \"\033[2J\" \tx\r\n"));
    assert_string_equal(r.error.message, "expected an object or a setting, found the string \"?[2J\"");
    assert_string_equal(r.error.excerpt, "/* ?[2J ?? \303\251 */ \"?[2J\" \tx");
    reading_end(&r);
}

static void an_error_in_a_text_below_a_byte_order_mark_has_its_column(void **state)
{
    reading r;

    (void)state;
    begin_exact(&r, TEXT("\357\273\277sphere { 0, 1 oops }"));
    assert_int_equal(r.error.column, 15);
    assert_string_equal(r.error.excerpt, "sphere { 0, 1 oops }");
    assert_int_equal(r.error.caret, 14);
    reading_end(&r);
}

static void missing_features_are_named_once_each_with_their_first_place(void **state)
{
    reading r;

    (void)state;
    begin_exact(&r, TEXT("#declare S = camera { bokeh { 1, 2 } };\n#declare T = camera { bokeh { 1, { [ 2 } };\n"
                         "sphere { 0, 1 pigment { rgb 1 } } // fog\n"
                         "fog { distance 1 } camera { T }"));
    assert_int_equal(r.status, POV_E_SYNTAX);
    reading_end(&r);
    begin_exact(&r, TEXT("#declare S = camera { bokeh { 1, 2 } };\n#declare T = camera { bokeh { 1, { [ 2 } } };\n"
                         "sphere { 0, 1 pigment { rgb 1 } } // rainbow\n"
                         "camera { T }"));
    assert_int_equal(r.status, POV_OK);
    assert_int_equal(r.model.leaves.count, 1);
    assert_int_equal(r.note_count, 1);
    assert_string_equal(r.notes[0].message, "\"bokeh\" is not supported yet and is left out");
    assert_int_equal(r.notes[0].line, 1);
    assert_int_equal(r.notes[0].column, 23);
    reading_end(&r);
}

/* Also in formulas a pigment that varies is that of the point. */
static void functions_of_pigments_are_evaluated(void **state)
{
    reading r;

    (void)state;
    begin_exact(&r, TEXT("#declare F = function { pigment { rgb 1/2 } }\n"
                         " #declare G = function { pigment { checker rgb 1, rgb 0 } }\n sphere { 0, F(1, 2, 3).red + G(.5, .5, .5).red }\n"
                         "#declare H = function { G(x, y, z).red * 2 } sphere { 0, 1 + H(.5, .5, 1.5) } sphere { 0, H(.5, 1.5, 1.5) }"));
    assert_int_equal(r.status, POV_OK);
    assert_int_equal(r.note_count, 0);
    assert_true(reading_shape(&r, 0)->numbers[0] == 1.5);
    assert_true(reading_shape(&r, 1)->numbers[0] == 1.0);
    assert_true(reading_shape(&r, 2)->numbers[0] == 2.0);
    reading_end(&r);
}

static void missing_features_are_errors_where_that_was_asked_for(void **state)
{
    static const char text[] = "sphere { 0, 1 }\n camera { bokeh { 1, 2 } }";
    reader_options options = { .strict = true };
    reading r;

    (void)state;
    reading_begin_bytes(&r, text, sizeof text - 1, &options, NULL);
    assert_int_equal(r.status, POV_E_UNSUPPORTED);
    assert_string_equal(r.error.message, "\"bokeh\" is not supported yet");
    assert_int_equal(r.error.line, 2);
    assert_int_equal(r.error.column, 11);
    reading_end(&r);
}

/* What stands in a part that is left out is done all the same: the second number of a stream is drawn. */
static void parts_that_are_left_out_have_their_effects(void **state)
{
    reading r;

    (void)state;
    begin_exact(&r, TEXT("#declare R = seed(3); #declare N = 0;\n"
                         "camera { bokeh { rand(R), #declare N = 7; 2 #if (0) } } } #end } }\n sphere { 0, rand(R) translate N }"));
    assert_int_equal(r.status, POV_OK);
    assert_int_equal(r.model.leaves.count, 1);
    assert_true(reading_shape(&r, 0)->numbers[0] ==
                (double)(1812433253u * (1812433253u * 3u + 12345u) + 12345u) / 4294967295.0);
    assert_true(r.model.leaves.items[0].map->v[0] == 7.0);
    reading_end(&r);
}

static void a_missing_plugin_is_named_with_the_path(void **state)
{
    static const char text[] = "camera { }\n sphere { 0, 1 }";
    reader_options options = { .dialect = POV_DIALECT_AUTO, .max_trace_level = 0 };
    pov_status status;
    pov_error error;
    registry *none;
    model m;
    env e;

    (void)state;
    env_init(&e, NULL, NULL, NULL);
    none = registry_create(&e, "/nowhere:/nonexistent", &error);
    model_init(&m, &e);
    status = reader_read(&m, none, text, sizeof text - 1, "scene.pov", &options, &error);
    assert_int_equal(status, POV_E_PLUGIN);
    assert_string_equal(error.message, "no plugin for \"sphere\" in /nowhere:/nonexistent");
    assert_int_equal(error.line, 2);
    assert_int_equal(error.column, 2);
    model_free(&m);
    model_init(&m, &e);
    assert_int_equal(reader_read(&m, none, text, sizeof text - 1, "scene.pov", NULL, NULL), POV_E_PLUGIN);
    model_free(&m);
    registry_destroy(none);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_wrong_text_is_refused_with_its_place),
        cmocka_unit_test(texts_in_macros_are_refused_with_their_callers),
        cmocka_unit_test(ten_thousand_nested_braces_are_refused),
        cmocka_unit_test(a_million_nested_comments_are_one_without_an_end),
        cmocka_unit_test(a_hundred_thousand_directives_and_signs_go_no_deeper),
        cmocka_unit_test(text_within_text_goes_only_so_deep),
        cmocka_unit_test(long_words_and_lines_are_shown_in_part),
        cmocka_unit_test(what_a_terminal_would_obey_is_not_shown),
        cmocka_unit_test(an_error_in_a_text_below_a_byte_order_mark_has_its_column),
        cmocka_unit_test(missing_features_are_named_once_each_with_their_first_place),
        cmocka_unit_test(functions_of_pigments_are_evaluated),
        cmocka_unit_test(missing_features_are_errors_where_that_was_asked_for),
        cmocka_unit_test(parts_that_are_left_out_have_their_effects),
        cmocka_unit_test(a_missing_plugin_is_named_with_the_path),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
