// A mask of what Embree's rays meet, for the sweeps of peers.py: one shape, one camera, single precision as Embree is.
//
//     embree_mask OUT.ppm sphere|box|polygon N size cx cy cz  location direction right up (three numbers each)
#include <embree3/rtcore.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace {

// As in exact.py.
const double box_half[3] = { 0.9, 0.7, 0.8 };
const double triangle[3][2] = { { -0.9, -0.8 }, { 0.9, -0.8 }, { 0.1, 0.9 } };
const unsigned box_faces[12][3] = { { 0, 1, 3 }, { 0, 3, 2 }, { 4, 6, 7 }, { 4, 7, 5 }, { 0, 4, 5 }, { 0, 5, 1 },
                                    { 2, 3, 7 }, { 2, 7, 6 }, { 0, 2, 6 }, { 0, 6, 4 }, { 1, 5, 7 }, { 1, 7, 3 } };

RTCGeometry make_sphere(RTCDevice device, const double *c, double size)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    float *at = static_cast<float *>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                                             4 * sizeof(float), 1));
    for (int i = 0; i < 3; i++)
        at[i] = static_cast<float>(c[i]);
    at[3] = static_cast<float>(size);
    return geometry;
}

RTCGeometry make_triangles(RTCDevice device, const double *c, double size, bool box)
{
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const unsigned corners = box ? 8 : 3, faces = box ? 12 : 1;
    float *at = static_cast<float *>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                             3 * sizeof(float), corners));
    unsigned *face = static_cast<unsigned *>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                                                                     RTC_FORMAT_UINT3, 3 * sizeof(unsigned), faces));
    for (unsigned i = 0; i < corners; i++)
        for (unsigned k = 0; k < 3; k++) {
            const double place = box ? ((i >> k & 1) ? box_half[k] : -box_half[k]) : k < 2 ? triangle[i][k] : 0.0;
            at[3 * i + k] = static_cast<float>(place * size + c[k]);
        }
    for (unsigned i = 0; i < 3 * faces; i++)
        face[i] = box ? box_faces[i / 3][i % 3] : i;
    return geometry;
}

bool meets(RTCScene scene, const double *o, const double *d)
{
    RTCIntersectContext context;
    RTCRayHit ray;

    rtcInitIntersectContext(&context);
    std::memset(&ray, 0, sizeof ray);
    ray.ray.org_x = static_cast<float>(o[0]), ray.ray.org_y = static_cast<float>(o[1]);
    ray.ray.org_z = static_cast<float>(o[2]);
    ray.ray.dir_x = static_cast<float>(d[0]), ray.ray.dir_y = static_cast<float>(d[1]);
    ray.ray.dir_z = static_cast<float>(d[2]);
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &ray);
    return ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

}

int main(int argc, char **argv)
{
    if (argc != 20)
        return 2;
    const int n = std::atoi(argv[3]);
    double a[16];
    for (int i = 0; i < 16; i++)
        a[i] = std::strtod(argv[4 + i], nullptr);
    const double size = a[0], *c = a + 1, *location = a + 4, *direction = a + 7, *right = a + 10, *up = a + 13;

    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);
    RTCGeometry geometry = std::strcmp(argv[2], "sphere") == 0 ? make_sphere(device, c, size)
                                                               : make_triangles(device, c, size, argv[2][0] == 'b');
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcCommitScene(scene);

    std::FILE *out = std::fopen(argv[1], "wb");
    if (!out)
        return 1;
    std::fprintf(out, "P6\n%d %d\n255\n", n, n);
    for (int y = 0; y < n; y++)
        for (int x = 0; x < n; x++) {
            const double u = (x + 0.5) / n - 0.5, v = 0.5 - (y + 0.5) / n;
            double d[3];
            for (int i = 0; i < 3; i++)
                d[i] = direction[i] + u * right[i] + v * up[i];
            const int value = meets(scene, location, d) ? 255 : 0;
            std::fputc(value, out), std::fputc(value, out), std::fputc(value, out);
        }
    std::fclose(out);
    rtcReleaseGeometry(geometry);
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
}
