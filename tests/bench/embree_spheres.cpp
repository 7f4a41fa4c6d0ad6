// A small tracer over Embree for the bench: it reads the sphere and mesh scenes that make_scenes.py writes and sends the rays
// that povc sends for them (camera, shadow and mirrored rays with the same cut-offs), in single precision.
//
//     embree_spheres SCENE.pov WIDTH HEIGHT [OUT.ppm] [--packet 8|16]
//
// Without --packet every ray goes alone (rtcIntersect1, rtcOccluded1). With it camera and shadow rays go in coherent
// packets; mirrored rays go alone, which is the faster way. One line of figures goes to standard output.
#include "embree_scene.hpp"

#include <embree3/rtcore.h>

#include <chrono>
#include <cstdint>
#include <limits>
#include <xmmintrin.h>

namespace {

const float far_away = std::numeric_limits<float>::infinity();
const float bailout = 1.0f / 255.0f;
// Of a scene about two units wide. In single precision a ray would else meet the sphere that it leaves.
const float offset = 2e-5f;

// ---- one ray, or N side by side ----

struct Hit { Vec point, normal, mirrored; const Look *look; };
struct Path { Vec start, direction; float weight; };

template <int N> struct Embree;
template <> struct Embree<8> {
    typedef RTCRayHit8 RayHit;
    typedef RTCRay8 Ray;
    static constexpr auto nearest = rtcIntersect8;
    static constexpr auto blocked = rtcOccluded8;
};
template <> struct Embree<16> {
    typedef RTCRayHit16 RayHit;
    typedef RTCRay16 Ray;
    static constexpr auto nearest = rtcIntersect16;
    static constexpr auto blocked = rtcOccluded16;
};

void set_ray(RTCRay &ray, Vec start, Vec direction, float length)
{
    ray.org_x = start.x, ray.org_y = start.y, ray.org_z = start.z;
    ray.dir_x = direction.x, ray.dir_y = direction.y, ray.dir_z = direction.z;
    ray.tnear = offset, ray.tfar = length;
    ray.mask = ~0u, ray.flags = 0, ray.time = 0;
}

template <typename Rays> void set_ray(Rays &rays, int lane, Vec start, Vec direction, float length)
{
    rays.org_x[lane] = start.x, rays.org_y[lane] = start.y, rays.org_z[lane] = start.z;
    rays.dir_x[lane] = direction.x, rays.dir_y[lane] = direction.y, rays.dir_z[lane] = direction.z;
    rays.tnear[lane] = offset, rays.tfar[lane] = length;
    rays.mask[lane] = ~0u, rays.flags[lane] = 0, rays.time[lane] = 0;
}

class Tracer {
public:
    uint64_t camera_rays = 0, shadow_rays = 0, mirrored_rays = 0;

    Tracer(const Scene &given, RTCScene built) : scene(given), tree(built) {}

    Vec follow(const Path &path, int level)
    {
        RTCIntersectContext context;
        RTCRayHit ray;

        rtcInitIntersectContext(&context);
        set_ray(ray.ray, path.start, path.direction, far_away);
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(tree, &context, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID)
            return scene.background;
        Hit hit = meet(path, ray.ray.tfar, { ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z }, ray.hit.primID);
        Vec sum = hit.look->rgb * hit.look->ambient;
        for (const Light &light : scene.lights)
            sum = sum + gather(hit, light);
        Path next;
        if (mirrors(path, hit, level, next))
            sum = sum + follow(next, level + 1) * hit.look->mirror;
        return sum;
    }

    // The same for N camera rays; out is set for those in `live`.
    template <int N> void follow_all(const Path *paths, unsigned live, Vec *out)
    {
        alignas(64) typename Embree<N>::RayHit rays;
        alignas(64) int valid[N];
        RTCIntersectContext context;
        Hit hits[N];
        unsigned met = 0;

        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        for (int i = 0; i < N; i++) {
            valid[i] = live >> i & 1 ? -1 : 0;
            set_ray(rays.ray, i, paths[i].start, paths[i].direction, far_away);
            rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        Embree<N>::nearest(valid, tree, &context, &rays);
        for (int i = 0; i < N; i++) {
            if (!(live >> i & 1))
                continue;
            out[i] = scene.background;
            if (rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID)
                continue;
            met |= 1u << i;
            hits[i] = meet(paths[i], rays.ray.tfar[i], { rays.hit.Ng_x[i], rays.hit.Ng_y[i], rays.hit.Ng_z[i] },
                           rays.hit.primID[i]);
            out[i] = hits[i].look->rgb * hits[i].look->ambient;
        }
        for (const Light &light : scene.lights)
            gather_all<N>(hits, met, light, out);
        for (int i = 0; i < N; i++) {
            Path next;
            if (met >> i & 1 && mirrors(paths[i], hits[i], 1, next))
                out[i] = out[i] + follow(next, 2) * hits[i].look->mirror;
        }
    }

private:
    const Scene &scene;
    RTCScene tree;

    Hit meet(const Path &path, float distance, Vec outward, unsigned which) const
    {
        Vec normal = unit(outward);

        if (dot(normal, path.direction) > 0)
            normal = normal * -1.0f;
        Vec mirrored = path.direction - normal * (2.0f * dot(normal, path.direction));
        return { path.start + path.direction * distance, normal, mirrored,
                 &scene.looks[scene.faces.empty() ? scene.compile_material[which] : 0] };
    }

    // Whether a light stands before the surface, its direction and distance.
    static bool sees(const Hit &hit, const Light &light, Vec &direction, float &distance, float &cosine)
    {
        Vec way = light.place - hit.point;

        distance = std::sqrt(dot(way, way));
        direction = way * (1.0f / distance);
        cosine = dot(hit.normal, direction);
        return cosine > 0;
    }

    static Vec answer(const Hit &hit, const Light &light, Vec direction, float cosine)
    {
        Vec sum = hit.look->rgb * (hit.look->diffuse * cosine);
        float along = dot(hit.mirrored, direction);

        if (along > 0) {
            float strength = hit.look->phong * std::pow(along, hit.look->phong_size);
            sum = sum + Vec { strength, strength, strength };
        }
        return sum * light.rgb;
    }

    Vec gather(const Hit &hit, const Light &light)
    {
        RTCIntersectContext context;
        RTCRay ray;
        Vec direction;
        float distance, cosine;

        if (!sees(hit, light, direction, distance, cosine))
            return { 0, 0, 0 };
        shadow_rays++;
        rtcInitIntersectContext(&context);
        set_ray(ray, hit.point, direction, distance);
        rtcOccluded1(tree, &context, &ray);
        return ray.tfar < 0 ? Vec { 0, 0, 0 } : answer(hit, light, direction, cosine);
    }

    template <int N> void gather_all(const Hit *hits, unsigned met, const Light &light, Vec *out)
    {
        alignas(64) typename Embree<N>::Ray rays;
        alignas(64) int valid[N];
        RTCIntersectContext context;
        Vec directions[N];
        float cosines[N], distance;

        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        for (int i = 0; i < N; i++) {
            valid[i] = met >> i & 1 && sees(hits[i], light, directions[i], distance, cosines[i]) ? -1 : 0;
            if (valid[i])
                set_ray(rays, i, hits[i].point, directions[i], distance);
            else
                set_ray(rays, i, { 0, 0, 0 }, { 0, 0, 1 }, -1);
            shadow_rays += valid[i] != 0;
        }
        Embree<N>::blocked(valid, tree, &context, &rays);
        for (int i = 0; i < N; i++)
            if (valid[i] && !(rays.tfar[i] < 0))
                out[i] = out[i] + answer(hits[i], light, directions[i], cosines[i]);
    }

    bool mirrors(const Path &path, const Hit &hit, int level, Path &next)
    {
        next = { hit.point, hit.mirrored, path.weight * hit.look->mirror };
        if (!(hit.look->mirror > 0) || level >= scene.levels || !(next.weight >= bailout))
            return false;
        mirrored_rays++;
        return true;
    }
};

// ---- the picture ----

class Camera {
public:
    Camera(const Scene &scene, int width, int height) : place(scene.location), wide(width), high(height)
    {
        Vec ahead = unit(scene.look_at - scene.location);
        float length = scene.aspect / 2.0f / std::tan(scene.angle * 3.14159265358979f / 360.0f);
        right = unit(cross({ 0, 1, 0 }, ahead)) * scene.aspect;
        up = unit(cross(ahead, right));
        forward = ahead * length;
    }
    Path path(int x, int y) const
    {
        float u = (x + 0.5f) / wide - 0.5f, v = 0.5f - (y + 0.5f) / high;
        return { place, unit(forward + right * u + up * v), 1.0f };
    }

private:
    Vec place, right, up, forward;
    int wide, high;
};

void draw_alone(Tracer &tracer, const Camera &camera, int width, int height, std::vector<Vec> &picture)
{
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            picture[static_cast<size_t>(y) * width + x] = tracer.follow(camera.path(x, y), 1);
    tracer.camera_rays = static_cast<uint64_t>(width) * height;
}

// Blocks of 4 by N / 4 pixels.
template <int N>
void draw_packets(Tracer &tracer, const Camera &camera, int width, int height, std::vector<Vec> &picture)
{
    for (int top = 0; top < height; top += N / 4)
        for (int left = 0; left < width; left += 4) {
            Path paths[N];
            Vec seen[N];
            unsigned live = 0;
            for (int i = 0; i < N; i++) {
                paths[i] = camera.path(left + i % 4, top + i / 4);
                if (left + i % 4 < width && top + i / 4 < height)
                    live |= 1u << i;
            }
            tracer.follow_all<N>(paths, live, seen);
            for (int i = 0; i < N; i++)
                if (live >> i & 1)
                    picture[static_cast<size_t>(top + i / 4) * width + left + i % 4] = seen[i];
        }
    tracer.camera_rays = static_cast<uint64_t>(width) * height;
}

// Linear light in 16 bits.
bool write_ppm(const char *path, const std::vector<Vec> &picture, int width, int height)
{
    std::FILE *file = std::fopen(path, "wb");

    if (!file)
        return false;
    std::fprintf(file, "P6\n%d %d\n65535\n", width, height);
    for (const Vec &pixel : picture)
        for (float value : { pixel.x, pixel.y, pixel.z }) {
            unsigned stored = static_cast<unsigned>(std::fmin(1.0f, std::fmax(0.0f, value)) * 65535.0f + 0.5f);
            std::fputc(static_cast<int>(stored >> 8), file);
            std::fputc(static_cast<int>(stored & 255), file);
        }
    return std::fclose(file) == 0;
}

// ---- the run ----

RTCGeometry spheres_of(RTCDevice device, const Scene &scene)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    void *buffer = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(Sphere),
                                           scene.spheres.size());

    std::memcpy(buffer, scene.spheres.data(), scene.spheres.size() * sizeof(Sphere));
    return geometry;
}

RTCGeometry mesh_of(RTCDevice device, const Scene &scene)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void *corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec),
                                            scene.corners.size());
    void *faces = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Face),
                                          scene.faces.size());

    std::memcpy(corners, scene.corners.data(), scene.corners.size() * sizeof(Vec));
    std::memcpy(faces, scene.faces.data(), scene.faces.size() * sizeof(Face));
    return geometry;
}

RTCScene build(RTCDevice device, const Scene &scene)
{
    RTCScene built = rtcNewScene(device);
    RTCGeometry geometry = scene.faces.empty() ? spheres_of(device, scene) : mesh_of(device, scene);

    rtcCommitGeometry(geometry);
    rtcAttachGeometry(built, geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneBuildQuality(built, RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(built);
    return built;
}

double seconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Options {
    const char *scene = nullptr, *picture = nullptr;
    int width = 0, height = 0, packet = 1;
};

bool read_options(int count, char **words, Options &options)
{
    int place = 0;

    for (int i = 1; i < count; i++) {
        if (!std::strcmp(words[i], "--packet") && i + 1 < count)
            options.packet = std::atoi(words[++i]);
        else if (place == 0)
            options.scene = words[i], place++;
        else if (place == 1)
            options.width = std::atoi(words[i]), place++;
        else if (place == 2)
            options.height = std::atoi(words[i]), place++;
        else
            options.picture = words[i];
    }
    return options.width > 0 && options.height > 0 &&
           (options.packet == 1 || options.packet == 8 || options.packet == 16);
}

} // namespace

int main(int count, char **words)
{
    Options options;

    if (!read_options(count, words, options)) {
        std::fprintf(stderr, "usage: embree_spheres SCENE.pov WIDTH HEIGHT [OUT.ppm] [--packet 8|16]\n");
        return 2;
    }
    // As Embree's manual asks of its users.
    _mm_setcsr(_mm_getcsr() | 0x8040);
    double begun = seconds();
    Scene scene = read_scene(options.scene);
    if (scene.spheres.empty() && scene.faces.empty()) {
        std::fprintf(stderr, "embree_spheres: no spheres and no mesh in %s\n", options.scene);
        return 1;
    }
    double parsed = seconds();
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene built = build(device, scene);
    double ready = seconds();
    Tracer tracer(scene, built);
    Camera camera(scene, options.width, options.height);
    std::vector<Vec> picture(static_cast<size_t>(options.width) * options.height);
    if (options.packet == 8)
        draw_packets<8>(tracer, camera, options.width, options.height, picture);
    else if (options.packet == 16)
        draw_packets<16>(tracer, camera, options.width, options.height, picture);
    else
        draw_alone(tracer, camera, options.width, options.height, picture);
    double drawn = seconds();
    uint64_t total = tracer.camera_rays + tracer.shadow_rays + tracer.mirrored_rays;
    std::printf("spheres: %zu parse: %.6f s build: %.6f s trace: %.6f s rays_camera: %llu rays_shadow: %llu "
                "rays_reflected: %llu rays_total: %llu\n", scene.spheres.size(), parsed - begun, ready - parsed,
                drawn - ready, (unsigned long long)tracer.camera_rays, (unsigned long long)tracer.shadow_rays,
                (unsigned long long)tracer.mirrored_rays, (unsigned long long)total);
    rtcReleaseScene(built);
    rtcReleaseDevice(device);
    if (options.picture && !write_ppm(options.picture, picture, options.width, options.height)) {
        std::fprintf(stderr, "embree_spheres: cannot write %s\n", options.picture);
        return 1;
    }
    return 0;
}
