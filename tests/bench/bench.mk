# The bench: povc, POV-Ray, Tachyon and Embree in turn on the same rays. What is not installed is left out.
EMBREE_BENCH = $(BUILD)/bench/embree_spheres
# Our own few lines around Embree are given all that this machine can do.
EMBREE_FLAGS = -std=c++17 -O3 -march=native -Wall -Wextra -Wshadow
BENCH_FLAGS ?=

$(EMBREE_BENCH): tests/bench/embree_spheres.cpp tests/bench/embree_scene.hpp
	$(call say,CXX,$@) $(CXX) $(EMBREE_FLAGS) $< -lembree3 -o $@

.PHONY: bench bench-quick bench-counts bench-whole bench-threads bench-scale bench-where bench-bits bench-docs embree-bench
# Embree's program is built only for the bench, and only where Embree is.
embree-bench:
	@if echo '#include <embree3/rtcore.h>' | $(CXX) -E -x c++ - >/dev/null 2>&1; then \
	    $(MAKE) --no-print-directory $(EMBREE_BENCH); \
	else \
	    echo "bench: Embree is left out, its headers are not installed (Debian: libembree-dev)"; \
	fi

bench: all embree-bench
	$(PYTHON) tests/bench/bench.py --povc $(POVC) --embree $(EMBREE_BENCH) --work $(BUILD)/bench $(BENCH_FLAGS)

bench-quick: BENCH_FLAGS += --quick
bench-quick: bench

STILL = $(BUILD)/bench/still.so
$(STILL): tests/bench/still.c
	$(call say,CC,$@) $(CC) $(BASE_FLAGS) -fvisibility=default -shared $< -o $@ -lpthread
bench-counts: all $(STILL)
	$(PYTHON) tests/bench/counts.py --povc $(POVC) --still $(STILL) --compiler '$(CC)' --work $(BUILD)/bench $(BENCH_FLAGS)

# Whole processes on the small scenes of the tests; 1 to N threads; the number of objects.
bench-whole: all
	$(PYTHON) tests/bench/whole.py --povc $(POVC) --work $(BUILD)/bench $(BENCH_FLAGS)
TAILS = $(BUILD)/bench/tails
$(TAILS): tests/bench/tails.c $(SHARED)
	$(call say,CC,$@) $(CC) $(BASE_FLAGS) $(LINK_FLAGS) $< -L$(BUILD)/lib -lpovtrace -Wl,-rpath,'$$ORIGIN/../lib' -o $@
bench-threads: all $(TAILS)
	$(PYTHON) tests/bench/threads.py --povc $(POVC) --tails $(TAILS) --work $(BUILD)/bench $(BENCH_FLAGS)
bench-scale: all
	$(PYTHON) tests/bench/scale.py --povc $(POVC) --work $(BUILD)/bench $(BENCH_FLAGS)
# Instructions by parts of the program, under callgrind; then all tables of docs/performance.md and docs/notes from what was measured.
bench-where: all
	$(PYTHON) tests/bench/where.py --povc $(POVC) --work $(BUILD)/bench $(BENCH_FLAGS)
bench-docs:
	$(PYTHON) tests/bench/tables.py --work $(BUILD)/bench

# Small pictures of the bench's scenes, the same bit for bit by every instruction set, tree and list, 1 to 8 threads. The
# copy of portable C alone is built for this.
PORTABLE = $(BUILD)/portable
bench-bits: all
	$(MAKE) --no-print-directory BUILD=$(PORTABLE) WIDE= CFLAGS='$(CFLAGS) -DPOV_PORTABLE' $(PORTABLE)/bin/povc \
	    $(patsubst $(BUILD)/%,$(PORTABLE)/%,$(PRIMITIVES) $(IMAGES))
	$(PYTHON) tests/bench/bits.py --povc $(POVC) --portable $(PORTABLE)/bin/povc --work $(BUILD)/bench $(BENCH_FLAGS)
