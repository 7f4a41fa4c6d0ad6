// client.cpp - the library from C++11: handles owned by smart pointers, a scene with an error in it, and the log.
#include <povtrace/povtrace.h>

#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace {

struct destroyer {
    void operator()(pov_context *context) const { pov_context_destroy(context); }
    void operator()(pov_scene *scene) const { pov_scene_destroy(scene); }
    void operator()(pov_tracer *tracer) const { pov_tracer_destroy(tracer); }
};

template <class T> using owned = std::unique_ptr<T, destroyer>;

void remember(void *user, pov_log_level level, const pov_error *note)
{
    if (level == POV_LOG_WARN)
        static_cast<std::vector<std::string> *>(user)->push_back(note->message);
}

owned<pov_scene> load(pov_context *context, const std::string &text, pov_error *err)
{
    pov_scene *scene = nullptr;

    pov_scene_load_text(&scene, context, text.data(), text.size(), "text", nullptr, err);
    return owned<pov_scene>(scene);
}

}

int main()
{
    std::vector<std::string> warnings;
    pov_context_desc desc = POV_INIT(desc);
    pov_context *made = nullptr;
    pov_error err = pov_error();

    desc.log = remember;
    desc.log_user = &warnings;
    if (pov_context_create(&made, &desc, &err) < 0)
        return 1;
    owned<pov_context> context(made);

    if (load(context.get(), "sphere { <0, 0, 0>, 1 pigmnet { } }", &err) || err.status >= 0 || err.line != 1 ||
        std::strcmp(err.hint, "pigment") != 0)
        return 2;
    owned<pov_scene> scene = load(context.get(), "sphere { <0, 0, 5>, -2 }", &err);
    if (!scene || warnings.empty() || pov_scene_object_count(scene.get()) != 1)
        return 3;
    context.reset();   // the scene keeps what it needs

    pov_tracer *tracer = nullptr;
    if (pov_tracer_create(&tracer, scene.get(), &err) < 0)
        return 4;
    owned<pov_tracer> keep(tracer);
    pov_hit hit = pov_hit();
    hit.size = sizeof hit;
    if (!pov_trace_hit(tracer, pov_vec3_of(0, 0, 0), pov_vec3_of(0, 0, 1), &hit) || hit.distance != 3.0)
        return 5;
    std::printf("%s; hit at %g\n", warnings[0].c_str(), hit.distance);
    return 0;
}
