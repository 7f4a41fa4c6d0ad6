// The sphere and mesh scenes of the bench, read from the simple text that make_scenes.py writes.
#ifndef BENCH_EMBREE_SCENE_HPP
#define BENCH_EMBREE_SCENE_HPP

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

struct Vec { float x, y, z; };
inline Vec operator+(Vec a, Vec b) { return { a.x + b.x, a.y + b.y, a.z + b.z }; }
inline Vec operator-(Vec a, Vec b) { return { a.x - b.x, a.y - b.y, a.z - b.z }; }
inline Vec operator*(Vec a, Vec b) { return { a.x * b.x, a.y * b.y, a.z * b.z }; }
inline Vec operator*(Vec a, float k) { return { a.x * k, a.y * k, a.z * k }; }
inline float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b)
{
    return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}
inline Vec unit(Vec a) { return a * (1.0f / std::sqrt(dot(a, a))); }

struct Look {
    Vec rgb { 0, 0, 0 };
    float ambient = 0.1f, diffuse = 0.6f, phong = 0, phong_size = 40, mirror = 0;
};
struct Light { Vec place, rgb; };
struct Sphere { float x, y, z, radius; };
struct Face { uint32_t corner[3]; };
struct Scene {
    Vec location { 0, 0, 0 }, look_at { 0, 0, 1 }, background { 0, 0, 0 };
    float angle = 60, aspect = 4.0f / 3.0f;
    int levels = 5;
    std::vector<Light> lights;
    std::vector<Sphere> spheres;
    std::vector<Look> looks;
    std::vector<uint16_t> compile_material;    // a number for each sphere
    std::vector<Vec> corners;                  // of a mesh, of the first look
    std::vector<Face> faces;
};

class Reader {
public:
    explicit Reader(const std::string &text) : at(text.data()), end(text.data() + text.size()) {}

    // The next word, brace or other sign; a number's text counts as a word. Empty at the end.
    std::string word()
    {
        skip();
        const char *from = at;
        while (at < end && (std::isalnum(static_cast<unsigned char>(*at)) || *at == '_' || *at == '#'))
            at++;
        if (at == from && at < end)
            at++;
        return std::string(from, at);
    }
    float number()
    {
        skip();
        float value = 0;
        std::from_chars_result got = std::from_chars(at, end, value);
        if (got.ec != std::errc()) {
            std::fprintf(stderr, "embree_spheres: expected a number at \"%.20s\"\n", at);
            std::exit(1);
        }
        at = got.ptr;
        return value;
    }
    Vec vector()
    {
        float x = number(), y = number(), z = number();
        return { x, y, z };
    }

private:
    const char *at, *end;

    void skip()
    {
        while (at < end && (std::isspace(static_cast<unsigned char>(*at)) || std::strchr(",<>;", *at)))
            at++;
    }
};

// Calls item(word) for each word of a block in braces and of the blocks within.
template <typename Item> void each_item(Reader &in, Item item)
{
    for (int depth = 0;;) {
        std::string word = in.word();
        depth += word == "{" ? 1 : word == "}" ? -1 : 0;
        if (depth == 0 || word.empty())
            return;
        if (word != "{" && word != "}")
            item(word);
    }
}

inline void read_look(Reader &in, const std::string &word, Look &look)
{
    if (word == "rgb")
        look.rgb = in.vector();
    else if (word == "ambient")
        look.ambient = in.number();
    else if (word == "diffuse")
        look.diffuse = in.number();
    else if (word == "phong")
        look.phong = in.number();
    else if (word == "phong_size")
        look.phong_size = in.number();
    else if (word == "reflection")
        look.mirror = in.number();
}

// A scene has a few looks, each used again and again.
inline uint16_t number_look(Scene &scene, const Look &look)
{
    size_t i = 0;

    while (i < scene.looks.size() && std::memcmp(&scene.looks[i], &look, sizeof look) != 0)
        i++;
    if (i == scene.looks.size())
        scene.looks.push_back(look);
    return static_cast<uint16_t>(i);
}

// The closing brace of a sphere or light is met by each_item, which is one level deeper from its start.
inline void read_sphere(Reader &in, Scene &scene)
{
    Vec centre = in.vector();
    float radius = in.number();
    Look look;

    for (std::string word = in.word(); word != "}" && !word.empty(); word = in.word())
        each_item(in, [&](const std::string &inner) { read_look(in, inner, look); });
    scene.spheres.push_back({ centre.x, centre.y, centre.z, radius });
    scene.compile_material.push_back(number_look(scene, look));
}

inline void read_mesh(Reader &in, Scene &scene)
{
    Look look;

    for (std::string word = in.word(); word != "}" && !word.empty(); word = in.word()) {
        if (word == "vertex_vectors" && in.word() == "{") {
            scene.corners.resize(static_cast<size_t>(in.number()));
            for (Vec &corner : scene.corners)
                corner = in.vector();
            in.word();
        } else if (word == "face_indices" && in.word() == "{") {
            scene.faces.resize(static_cast<size_t>(in.number()));
            for (Face &face : scene.faces)
                for (uint32_t &corner : face.corner)
                    corner = static_cast<uint32_t>(in.number());
            in.word();
        } else {
            each_item(in, [&](const std::string &inner) { read_look(in, inner, look); });
        }
    }
    scene.looks.push_back(look);
}

inline void read_light(Reader &in, Scene &scene)
{
    Light light = { in.vector(), { 0, 0, 0 } };

    for (std::string word = in.word(); word != "}" && !word.empty(); word = in.word())
        if (word == "rgb")
            light.rgb = in.vector();
    scene.lights.push_back(light);
}

inline void read_camera(Reader &in, const std::string &word, Scene &scene)
{
    if (word == "location")
        scene.location = in.vector();
    else if (word == "look_at")
        scene.look_at = in.vector();
    else if (word == "angle")
        scene.angle = in.number();
    else if (word == "right")
        scene.aspect = in.vector().x;
}

inline Scene read_scene(const char *path)
{
    std::ifstream file(path, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    Reader in(text);
    Scene scene;

    for (std::string word = in.word(); !word.empty(); word = in.word()) {
        if (word == "sphere" && in.word() == "{")
            read_sphere(in, scene);
        else if (word == "mesh2" && in.word() == "{")
            read_mesh(in, scene);
        else if (word == "light_source" && in.word() == "{")
            read_light(in, scene);
        else if (word == "camera")
            each_item(in, [&](const std::string &inner) { read_camera(in, inner, scene); });
        else if (word == "background")
            each_item(in, [&](const std::string &inner) {
                if (inner == "rgb")
                    scene.background = in.vector();
            });
        else if (word == "global_settings")
            each_item(in, [&](const std::string &inner) {
                if (inner == "max_trace_level")
                    scene.levels = static_cast<int>(in.number());
            });
    }
    return scene;
}

#endif
