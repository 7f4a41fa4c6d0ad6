/* povtrace.h - the library, for programs. Plugins include povtrace/plugin.h instead. */
#ifndef POVTRACE_H
#define POVTRACE_H
#include <povtrace/base.h>
#include <povtrace/build.h>
#include <povtrace/image.h>
#include <povtrace/math.h>
#include <povtrace/plot.h>
#include <povtrace/render.h>
#include <povtrace/scene.h>
#include <povtrace/trace.h>
#endif
