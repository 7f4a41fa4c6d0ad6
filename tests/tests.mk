# Tests: every tests/<room>/test_*.c is a cmocka program linked with the static library.
TEST_SOURCES  = $(filter-out $(TESTS_LEFT_OUT),$(sort $(wildcard tests/*/test_*.c)))
SUPPORT_SOURCES := $(sort $(wildcard tests/support/*.c))
# Tests of what is compiled otherwise for wider processors, once more with each copy of the library and the primitives.
COPY_TESTS    = $(filter-out %_build.c %_rough.c,$(wildcard $(patsubst %,tests/unit/test_%_*.c,model bvh world query shade texture light media))) \
                $(wildcard tests/limits/test_*.c) tests/api/test_pictures.c tests/plugins/test_contract.c \
                $(patsubst %,tests/numerics/test_%.c,primitives leaving)
TEST_PROGRAMS = $(TEST_SOURCES:%.c=$(BUILD)/%) $(foreach w,$(WIDE),$(COPY_TESTS:tests/%.c=$(BUILD)/tests/$w/%))

OUT_OF_TREE = $(addprefix $(BUILD)/tests/plugins/out_of_tree/,disc.so torus.so)
CONTRACT_SOURCES = $(wildcard tests/plugins/contract_*.c) tests/plugins/subject.c

# $(1): the copy's folder, as in COPY_RULES. Tests find in TEST_BUILD what was built, in TEST_ROOT the tree's scenes.
define TEST_RULES
$(BUILD)/obj/$(1)tests/%.o: ROOM_FLAGS = -Ilib -Itests -DTEST_BUILD='"$(abspath $(BUILD))"' -DTEST_ROOT='"$(CURDIR)"' \
    -DTEST_COPY='"$(1)"'
$(BUILD)/tests/$(1)%: $(BUILD)/obj/$(1)tests/%.o $(SUPPORT_SOURCES:%.c=$(BUILD)/obj/$(1)%.o) $(BUILD)/lib/$(1)libpovtrace.a
	$$(call say,LINK,$$@) $$(CC) $$(LINK_FLAGS) $$(filter %.o,$$^) $$(filter %.a,$$^) -lcmocka $$(TEST_LIBS) $$(SYSTEM_LIBS) -o $$@

$(BUILD)/tests/$(1)numerics/%: TEST_LIBS = -lmpfr -lgmp
$(addprefix $(BUILD)/tests/$(1)numerics/test_,primitives leaving maps watertight csg csg_outline narrow findings piecewise facets strokes outlines): \
    $(patsubst %,$(BUILD)/obj/$(1)tests/numerics/%.o,real probe exact exact_torus families families_round) | $(PRIMITIVES)
$(addprefix $(BUILD)/tests/$(1)numerics/test_,primitives leaving findings): $(BUILD)/obj/$(1)tests/numerics/leaving.o
$(addprefix $(BUILD)/tests/$(1)numerics/test_,maps findings): $(BUILD)/obj/$(1)tests/numerics/real_map.o
$(BUILD)/tests/$(1)numerics/test_findings: $(BUILD)/obj/$(1)tests/numerics/findings.o
$(BUILD)/tests/$(1)numerics/test_primitives: $(BUILD)/obj/$(1)tests/numerics/harness.o
$(addprefix $(BUILD)/tests/$(1)numerics/test_,piecewise strokes outlines): $(patsubst %,$(BUILD)/obj/$(1)tests/numerics/%.o,piecewise kinds)
$(addprefix $(BUILD)/tests/$(1)numerics/test_,strokes outlines): $(BUILD)/obj/$(1)tests/numerics/spline_real.o
$(BUILD)/tests/$(1)numerics/test_outlines $(BUILD)/tests/$(1)numerics/test_narrow: $(BUILD)/obj/$(1)tests/numerics/font.o
$(BUILD)/tests/$(1)plugins/test_contract: $(CONTRACT_SOURCES:%.c=$(BUILD)/obj/$(1)%.o) | $(PRIMITIVES) $(OUT_OF_TREE)
endef
$(eval $(call TEST_RULES,))
$(foreach w,$(WIDE),$(eval $(call TEST_RULES,$w/)))

# What we compare with: each method a folder of plugins, built from one source a primitive; for wider processors too.
METHOD_FLAGS_textbook =
METHOD_FLAGS_qform = -DRECENTRED
METHOD_FLAGS_twofold = -DDOUBLE_DOUBLE
METHOD_SOURCES = $(sort $(wildcard tests/numerics/methods/primitives/*.c))
METHOD_NAMES = $(foreach w,primitives $(WIDE:%=primitives/%),$(METHOD_SOURCES:tests/numerics/methods/primitives/%.c=$w/%.so))
METHODS = $(foreach m,textbook qform twofold,$(METHOD_NAMES:%=$(BUILD)/tests/numerics/$m/%))
# The method, a folder's ending, and the kit to go with it.
define METHOD_RULE
$(BUILD)/tests/numerics/$1/primitives$2/%.so: tests/numerics/methods/primitives/%.c $(wildcard tests/numerics/methods/*.h) $3
	$$(call say,CC,$$@) $(CC) $(filter-out -MMD -MP,$(BASE_FLAGS)) $(if $2,-march=$(2:/%=%)) $(METHOD_FLAGS_$1) -Iplugins -Itests -shared \
	    -Wl,--gc-sections $(LINK_FLAGS) $$< $3 -lm -o $$@
endef
$(foreach m,textbook qform twofold,$(eval $(call METHOD_RULE,$m,,$(BUILD)/obj/plugins/common.a)))
$(foreach w,$(WIDE),$(foreach m,textbook qform twofold,$(eval $(call METHOD_RULE,$m,/$w,$(BUILD)/obj/$w/plugins/common.a))))
.PHONY: accuracy-methods
accuracy-methods: $(METHODS)

# The same harness for long: RAYS of torture for each kind, and a table of all families and methods; EDGES rays at shared
# edges; LEAVING rays that leave a surface, for every kind and family; FINDINGS rays for every kind and family of
# tests/numerics/findings.c, 1e7 in all.
RAYS ?= 500000
EDGES ?= 100000000
LEAVING ?= 1000000
FINDINGS ?= 160000
.PHONY: accuracy
accuracy: $(addprefix $(BUILD)/tests/numerics/,test_primitives test_watertight test_leaving test_maps test_findings test_piecewise test_facets test_strokes test_outlines) $(METHODS)
	$(BUILD)/tests/numerics/test_primitives $(RAYS) $(BUILD)/accuracy.csv
	$(BUILD)/tests/numerics/test_watertight $(EDGES)
	$(BUILD)/tests/numerics/test_leaving $(LEAVING)
	$(BUILD)/tests/numerics/test_maps $(RAYS)
	$(BUILD)/tests/numerics/test_piecewise $(RAYS)
	$(BUILD)/tests/numerics/test_facets $(RAYS)
	$(BUILD)/tests/numerics/test_strokes $(RAYS)
	$(BUILD)/tests/numerics/test_outlines $(RAYS)
	$(BUILD)/tests/numerics/test_findings $(FINDINGS)
	$(MAKE) --no-print-directory accuracy-report

# The tables of docs/numerics.md and its plots, from the table that was measured last. Plots need cairo.
.PHONY: accuracy-report accuracy-cost
$(BUILD)/tests/numerics/accuracy_plot: tests/numerics/accuracy_plot.c
	$(call say,CC,$@) $(CC) $(BASE_FLAGS) $$($(PKG_CONFIG) --cflags cairo) $< $$($(PKG_CONFIG) --libs cairo) -lm -o $@
accuracy-report: $(BUILD)/tests/numerics/accuracy_plot
	$(PYTHON) tests/numerics/accuracy_report.py $(BUILD)/accuracy.csv docs/numerics.md docs/images $<

# Whole renders against the same program with textbook kernels: the gallery, and the bench's scenes.
COST_BENCH ?= flake-4 spheres-1e2 spheres-1e4 mixed-1e2 mixed-1e4 rings tree hall glass strip
COST_FLAGS ?=
accuracy-cost: all $(METHODS)
	$(PYTHON) tests/bench/make_scenes.py --out $(BUILD)/bench/scenes $(COST_BENCH)
	$(PYTHON) tests/numerics/cost.py --povc $(POVC) --product $(BUILD)/lib/povtrace --textbook $(BUILD)/tests/numerics/textbook \
	    --csv $(BUILD)/cost.csv --document docs/numerics.md $(COST_FLAGS) $(wildcard scenes/gallery/*.pov) $(COST_BENCH:%=$(BUILD)/bench/scenes/%.pov)

# A plugin as a stranger would build it, held to the contract with our own.
$(BUILD)/tests/plugins/out_of_tree/%.so: tests/plugins/out_of_tree/%.c $(wildcard lib/include/povtrace/*.h)
	$(call say,CC,$@) $(CC) -std=c99 -Wall -Wextra -O2 -ffp-contract=off -shared -fPIC -Ilib/include $(SANITIZE) $< -lm -o $@
$(BUILD)/tests/plugins/test_parse: | $(PRIMITIVES)
# The same two with the claim to be certified: right, in plain double, and with every distance off by 1e-9.
CLAIM = $(CC) -std=c99 -Wall -Wextra -O2 -ffp-contract=off -shared -fPIC -Ilib/include -Itests $(SANITIZE)
CLAIM_off = -DERROR=1e-9
$(BUILD)/tests/plugins/claims/%/torus.so: tests/plugins/out_of_tree/torus.c $(wildcard lib/include/povtrace/*.h)
	$(call say,CC,$@) $(CLAIM) -DFLAGS='(POV_SHAPE_SOLID | POV_SHAPE_CERTIFIED)' $(CLAIM_$*) $< -lm -o $@
$(BUILD)/tests/plugins/claims/%/disc.so: tests/plugins/claims/disc.c tests/plugins/out_of_tree/disc.c $(wildcard lib/include/povtrace/*.h)
	$(call say,CC,$@) $(CLAIM) $(CLAIM_$*) $< -lm -o $@
$(BUILD)/tests/plugins/test_claims: | $(BUILD)/tests/plugins/test_contract \
    $(addprefix $(BUILD)/tests/plugins/claims/,naive/torus.so off/torus.so right/disc.so off/disc.so)
$(BUILD)/tests/plugins/test_images: TEST_LIBS = -lpng
$(BUILD)/tests/plugins/test_images: | $(IMAGES)
$(BUILD)/tests/plugins/test_images_load: | $(IMAGES)
$(BUILD)/tests/unit/test_sdl_images $(BUILD)/tests/unit/test_sdl_scenes: | $(IMAGES)
$(BUILD)/tests/golden/test_golden: | $(IMAGES) $(PRIMITIVES)
$(BUILD)/obj/tests/plugins/test_images.o: ROOM_FLAGS += $(shell $(PKG_CONFIG) --cflags libpng)
# The pure pieces of povc are tested with the program's own objects.
$(BUILD)/obj/tests/cli/%.o: ROOM_FLAGS += -Icli
ARGS_OBJECTS = $(patsubst %,$(BUILD)/obj/cli/%.o,args args_limit args_value args_places args_frames)
$(BUILD)/tests/cli/test_args: $(ARGS_OBJECTS)
$(BUILD)/tests/cli/test_text: $(BUILD)/obj/cli/text.o
$(BUILD)/tests/cli/test_progress: $(BUILD)/obj/cli/progress.o $(BUILD)/obj/cli/messages.o $(BUILD)/obj/cli/text.o
$(BUILD)/tests/cli/test_povray: $(patsubst %,$(BUILD)/obj/cli/%.o,povray povray_ini povray_frame frames)

# Scripts are run like programs, and first, for some take longest; they find what was built in $BUILD_DIR and the compiler in $CC.
TEST_SCRIPTS = $(VIEWER_SCRIPTS) $(sort $(wildcard tests/cli/run.sh tests/docs/examples.py tests/corpus/run.sh tests/docs/links.py tests/install/run.sh tests/cluster/run.sh tests/python/run.sh)) tests/runner/run.sh

.PHONY: test tests
tests: all $(TEST_PROGRAMS)
test: deps
	$(MAKE) tests
	BUILD_DIR='$(abspath $(BUILD))' CC='$(CC)' CXX='$(CXX)' tests/run.sh $(TEST_SCRIPTS) $(TEST_PROGRAMS)

# Another architecture: by a cross compiler, without a warning, and run by qemu. Whatever else pkg-config finds for it is
# built as well. Part of `make test` where there is a compiler.
AARCH64 = aarch64-linux-gnu
.PHONY: aarch64 build-aarch64
build-aarch64:
	$(MAKE) --no-print-directory BUILD=$(BUILD)-aarch64 CC=$(AARCH64)-gcc AR=$(AARCH64)-ar WIDE= WERROR=-Werror \
	    PKG_CONFIG=$(or $(shell command -v $(AARCH64)-pkg-config),false) runtime
aarch64: all build-aarch64
	BUILD_DIR='$(abspath $(BUILD))' tests/run.sh tests/aarch64/run.sh
ifneq ($(shell command -v $(AARCH64)-gcc),)
tests: build-aarch64
TEST_SCRIPTS += tests/aarch64/run.sh
endif

# The same tests under the sanitizers, each in a build of its own. POVTRACE_STORM=60 in the environment has jobs restarted,
# paused, resized and cancelled at random moments for a minute.
SANITIZED_TESTS = $(filter-out tests/numerics/%,$(TEST_SOURCES))
.PHONY: asan tsan ubsan
asan:
	$(MAKE) BUILD=build-asan OPTIMISE=-O1 SANITIZE='-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer' all $(SANITIZED_TESTS:%.c=build-asan/%)
	LSAN_OPTIONS='suppressions=$(CURDIR)/tests/support/lsan.supp print_suppressions=0' BUILD_DIR='$(CURDIR)/build-asan' \
	    tests/run.sh $(SANITIZED_TESTS:%.c=build-asan/%) $(filter tests/cli/%,$(TEST_SCRIPTS))
	$(if $(shell command -v clang),$(MAKE) ubsan,@echo "clang's sanitizer was left out: there is no clang")
# Clang's finds what gcc's does not: arithmetic on null pointers, among others.
ubsan:
	$(MAKE) BUILD=build-ubsan CC=clang OPTIMISE=-O1 SANITIZE='-fsanitize=undefined -fno-sanitize-recover=undefined -shared-libsan' \
	    LDFLAGS="-Wl,-rpath,$$(dirname "$$(clang -print-file-name=libclang_rt.ubsan_standalone-$$(uname -m).so)")" \
	    all $(SANITIZED_TESTS:%.c=build-ubsan/%)
	BUILD_DIR='$(CURDIR)/build-ubsan' tests/run.sh $(SANITIZED_TESTS:%.c=build-ubsan/%)
tsan:
	$(MAKE) BUILD=build-tsan OPTIMISE=-O1 SANITIZE=-fsanitize=thread all $(SANITIZED_TESTS:%.c=build-tsan/%)
	TSAN_OPTIONS='suppressions=$(CURDIR)/tests/support/tsan.supp ignore_noninstrumented_modules=1' \
	    BUILD_DIR='$(CURDIR)/build-tsan' tests/run.sh $(SANITIZED_TESTS:%.c=build-tsan/%)

# What strangers' bytes do: libFuzzer and the sanitizers on each harness of tests/fuzz, SECONDS each (-j4: all at once),
# beginning with the scenes of the tree. Findings and logs are left in build-fuzz/tests/fuzz. The slowest of the scenes, one
# with photons, takes 11 s of an idle core in this build: an input that takes a minute of a shared one is a finding.
SECONDS ?= 60
HARNESSES = scene image checkpoint arguments
$(BUILD)/obj/tests/fuzz/arguments.o: ROOM_FLAGS += -Icli
$(BUILD)/tests/fuzz/test_replay: $(HARNESSES:%=$(BUILD)/obj/tests/fuzz/%.o) $(ARGS_OBJECTS) | $(PLUGINS)
$(BUILD)/tests/fuzz/fuzz_%: tests/fuzz/main.c $(HARNESSES:%=$(BUILD)/obj/tests/fuzz/%.o) $(ARGS_OBJECTS) \
    $(SUPPORT_SOURCES:%.c=$(BUILD)/obj/%.o) $(STATIC)
	$(call say,LINK,$@) $(CC) $(BASE_FLAGS) -Itests -DHARNESS=fuzz_$* -DTEST_BUILD='"$(abspath $(BUILD))"' -fsanitize=fuzzer -rdynamic $(filter-out %.h,$^) -lcmocka \
	    $(SYSTEM_LIBS) -o $@
.PHONY: fuzz fuzzers build-fuzzers $(HARNESSES:%=fuzz-%)
fuzzers: $(PLUGINS) $(HARNESSES:%=$(BUILD)/tests/fuzz/fuzz_%)
fuzz: $(HARNESSES:%=fuzz-%)
build-fuzzers:
	$(MAKE) BUILD=build-fuzz CC=clang WIDE= OPTIMISE=-O1 LDFLAGS='-Wl,-z,undefs' \
	    SANITIZE='-fsanitize=address,undefined,fuzzer-no-link -fno-sanitize-recover=undefined -fno-omit-frame-pointer' fuzzers
$(HARNESSES:%=fuzz-%): fuzz-%: build-fuzzers
	@mkdir -p build-fuzz/tests/fuzz/$*
	build-fuzz/tests/fuzz/fuzz_$* -max_total_time=$(SECONDS) -timeout=60 -rss_limit_mb=2048 -print_final_stats=1 \
	    -artifact_prefix=build-fuzz/tests/fuzz/$*- $(if $(filter scene,$*),-dict=tests/fuzz/scene.dict) build-fuzz/tests/fuzz/$* \
	    $(if $(filter scene,$*),scenes/test) > build-fuzz/tests/fuzz/$*.log 2>&1 || { tail -40 build-fuzz/tests/fuzz/$*.log; exit 1; }
	@echo "$*: $$(sed -n 's/^stat::number_of_executed_units: *//p' build-fuzz/tests/fuzz/$*.log) inputs, no finding"

# Every scene in povtrace and in an installed POV-Ray, picture against picture.
.PHONY: compare
compare: all
	$(PYTHON) tests/compare/test_harness.py
	$(PYTHON) tests/compare/compare.py --povc $(POVC)

# Folders of probe scenes with POV-Ray's pictures, as tests/compare/README.md says: which scenes are drawn alike.
PROBES ?=
# The same scenes scaled and far away look as they do (tests/compare/scaled.py).
.PHONY: scaled
scaled: all
	$(foreach f,$(PROBES),$(PYTHON) tests/compare/scaled.py --povc $(POVC) $f;)

.PHONY: probes
probes: all
	$(foreach f,$(PROBES),$(PYTHON) tests/compare/probes.py --povc $(POVC) $f;)

# Mistakes made on purpose in a copy of the tree, each of which a test must notice; some ten minutes.
.PHONY: mutate
mutate:
	$(PYTHON) tests/mutate/mutate.py --build $(BUILD)

# The scenes that come with POV-Ray (Debian: povray-examples): which are read, which match, what the others lack.
CORPUS_FLAGS ?=
.PHONY: corpus
corpus: all
	$(PYTHON) tests/corpus/corpus.py --povc $(POVC) --work $(BUILD)/corpus $(CORPUS_FLAGS)
# The same in every way that must give the same bits; and once, small, in a build of its own with sanitizers.
.PHONY: corpus-bits corpus-asan
corpus-bits: all
	$(PYTHON) tests/corpus/bits.py --povc $(POVC) --work $(BUILD)/corpus-bits $(CORPUS_FLAGS)
corpus-asan:
	$(MAKE) BUILD=build-asan WIDE= OPTIMISE=-O1 SANITIZE='-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer' runtime
	LSAN_OPTIONS='suppressions=$(CURDIR)/tests/support/lsan.supp print_suppressions=0' \
	    $(PYTHON) tests/corpus/bits.py --povc build-asan/bin/povc --work build-asan/corpus --once --size 32x24 $(CORPUS_FLAGS)

# Scenes as programs write them today: the programs are installed where they can be, and render by the name povray.
.PHONY: programs
programs: all
	$(PYTHON) tests/programs/programs.py --povc $(POVC) --work $(BUILD)/programs $(PROGRAMS_FLAGS)

# What povc says of its error against references of 65 536 samples a pixel, which take over an hour the first time.
VALIDATE_FLAGS ?=
.PHONY: validate-error
validate-error: all
	$(PYTHON) tests/compare/validate_error.py --povc $(POVC) --work $(BUILD)/validate $(VALIDATE_FLAGS)

include tests/bench/bench.mk
include tests/numerics/peers/peers.mk
