# povtrace. `make demo` shows what it does, `make test` proves it; `make help` lists the rest.
VERSION   = 0.1.0
SOVERSION = 0
BUILD    ?= build
PREFIX   ?= /usr/local
DESTDIR  ?=
LIBDIR   ?= $(PREFIX)/lib
CC       ?= cc
CXX      ?= c++
PYTHON   ?= python3
OPTIMISE ?= -O3
SANITIZE ?=
WERROR   ?=
PKG_CONFIG ?= pkg-config
# The library and the primitives are built once more for these processors, beside the baseline; the system's loader
# picks, and the pictures are the same to the bit. WIDE= leaves that out.
WIDE     ?= $(if $(SANITIZE),,$(shell for w in x86-64-v3 x86-64-v4; do \
               $(CC) -march=$$w -dM -E -x c /dev/null 2>/dev/null | grep -q __gnu_linux__ && echo $$w; done))
WIDE     := $(WIDE)

WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wpointer-arith \
           -Wwrite-strings -Wvla -Wundef $(WERROR)
# Contraction would make the bits of a result depend on the machine. Nobody reads floating-point traps or errno, and
# loops over lanes become vectors only without them.
CFLAGS  ?= -g
BASE_FLAGS = -std=c99 -D_POSIX_C_SOURCE=200809L $(OPTIMISE) -ffp-contract=off -fno-math-errno -fno-trapping-math -fPIC \
             -ffunction-sections -fvisibility=hidden -MMD -MP $(WARNINGS) $(MARCH) $(CFLAGS) $(SANITIZE)
LIB_FLAGS  = $(BASE_FLAGS) -Ilib/include -Ilib -DPOV_PLUGIN_DIR='"$(LIBDIR)/povtrace"'
USER_FLAGS = $(BASE_FLAGS) -Ilib/include
LINK_FLAGS = $(LDFLAGS) $(SANITIZE) $(OPTIMISE)
SYSTEM_LIBS = -lm -ldl -lpthread

LIB_SOURCES    = $(sort $(wildcard lib/*/*.c))
LIB_OBJECTS    = $(LIB_SOURCES:%.c=$(BUILD)/obj/%.o)
KIT_OBJECTS    = $(patsubst %.c,$(BUILD)/obj/%.o,$(sort $(wildcard plugins/kit/*.c)))
KIT            = $(BUILD)/obj/plugins/kit.a
PRIMITIVES     = $(patsubst plugins/%.c,$(BUILD)/lib/povtrace/%.so,$(sort $(wildcard plugins/primitives/*.c)))
IMAGES         = $(patsubst plugins/%.c,$(BUILD)/lib/povtrace/%.so,$(sort $(wildcard plugins/images/*.c)))
# Plots need cairo; without it all else is built.
PLOTS         := $(shell $(PKG_CONFIG) --exists cairo-svg cairo-png && echo $(BUILD)/lib/povtrace/plots/plot.so)
PLUGINS        = $(PRIMITIVES) $(IMAGES) $(PLOTS)
CLI_OBJECTS    = $(patsubst %.c,$(BUILD)/obj/%.o,$(sort $(wildcard cli/*.c)))
SHARED         = $(BUILD)/lib/libpovtrace.so.$(VERSION)
STATIC         = $(BUILD)/lib/libpovtrace.a
POVC           = $(BUILD)/bin/povc
# Of what is WIDE, where the loader and the library look for it.
WIDE_SHARED    = $(WIDE:%=$(BUILD)/lib/glibc-hwcaps/%/libpovtrace.so.$(VERSION))
WIDE_PLUGINS   = $(foreach w,$(WIDE),$(PRIMITIVES:$(BUILD)/lib/povtrace/primitives/%=$(BUILD)/lib/povtrace/primitives/$(w)/%))

.PHONY: all
all: $(SHARED) $(STATIC) $(PLUGINS) $(WIDE_SHARED) $(WIDE_PLUGINS) $(POVC)

# ---- the library ----

$(BUILD)/obj/lib/%.o: lib/%.c
	@mkdir -p $(@D)
	$(CC) $(LIB_FLAGS) -c $< -o $@

$(STATIC): $(LIB_OBJECTS)
	@mkdir -p $(@D)
	rm -f $@
	ar rcs $@ $^

LINK_SHARED = $(CC) -shared -Wl,-soname,libpovtrace.so.$(SOVERSION) -Wl,--version-script,lib/api/libpovtrace.map \
              -Wl,--no-undefined $(LINK_FLAGS) $(filter %.o,$^) $(SYSTEM_LIBS) -o $@

$(SHARED): $(LIB_OBJECTS) lib/api/libpovtrace.map
	@mkdir -p $(@D)
	$(LINK_SHARED)
	ln -sf $(@F) $(@D)/libpovtrace.so.$(SOVERSION)
	ln -sf libpovtrace.so.$(SOVERSION) $(@D)/libpovtrace.so

# ---- plugins: a file each, linked against nothing of povtrace ----

$(BUILD)/obj/plugins/%.o: plugins/%.c
	@mkdir -p $(@D)
	$(CC) $(USER_FLAGS) -Iplugins -c $< -o $@

$(BUILD)/obj/plugins/images/png.o: USER_FLAGS += $(shell $(PKG_CONFIG) --cflags libpng)
$(BUILD)/lib/povtrace/images/png.so: PLUGIN_LIBS = $(shell $(PKG_CONFIG) --libs libpng)

$(BUILD)/obj/plugins/plots/plot.o: USER_FLAGS += $(shell $(PKG_CONFIG) --cflags cairo)
# Cairo and what it stands on keep caches for ever: unloaded and loaded again, they would leak them each time.
$(BUILD)/lib/povtrace/plots/plot.so: PLUGIN_LIBS = $(shell $(PKG_CONFIG) --libs cairo) -Wl,-z,nodelete

$(KIT): $(KIT_OBJECTS)
	rm -f $@
	ar rcs $@ $^

LINK_PLUGIN = $(CC) -shared -Wl,--no-undefined -Wl,--gc-sections -Wl,--as-needed $(LINK_FLAGS) $^ $(PLUGIN_LIBS) -lm -o $@

$(BUILD)/lib/povtrace/%.so: $(BUILD)/obj/plugins/%.o $(KIT)
	@mkdir -p $(@D)
	$(LINK_PLUGIN)

# ---- the same for wider processors ----

# Sums and products of 512 bits, however few, lower the clock of Intel's servers by 8 %, which is more than they spare.
WIDE_FLAGS_x86-64-v4 = -mprefer-vector-width=256

# $(1): the processors.
define WIDE_RULES
$(BUILD)/obj/$(1)/%.o: MARCH = -march=$(1) $(WIDE_FLAGS_$(1)) -DPOV_WIDE='"$(1)"'

$(BUILD)/obj/$(1)/lib/%.o: lib/%.c
	@mkdir -p $$(@D)
	$$(CC) $$(LIB_FLAGS) -c $$< -o $$@

$(BUILD)/lib/glibc-hwcaps/$(1)/libpovtrace.so.$(VERSION): $(LIB_SOURCES:%.c=$(BUILD)/obj/$(1)/%.o) lib/api/libpovtrace.map
	@mkdir -p $$(@D)
	$$(LINK_SHARED)
	ln -sf $$(@F) $$(@D)/libpovtrace.so.$(SOVERSION)

$(BUILD)/obj/$(1)/plugins/%.o: plugins/%.c
	@mkdir -p $$(@D)
	$$(CC) $$(USER_FLAGS) -Iplugins -c $$< -o $$@

$(BUILD)/obj/$(1)/plugins/kit.a: $(KIT_OBJECTS:$(BUILD)/obj/%=$(BUILD)/obj/$(1)/%)
	rm -f $$@
	ar rcs $$@ $$^

$(BUILD)/lib/povtrace/primitives/$(1)/%.so: $(BUILD)/obj/$(1)/plugins/primitives/%.o $(BUILD)/obj/$(1)/plugins/kit.a
	@mkdir -p $$(@D)
	$$(LINK_PLUGIN)
endef
$(foreach w,$(WIDE),$(eval $(call WIDE_RULES,$(w))))

# The loader would take what an earlier make left.
STALE := $(filter-out $(WIDE),$(notdir $(wildcard $(BUILD)/lib/glibc-hwcaps/*)))
ifneq ($(STALE),)
.PHONY: narrow
all: narrow
narrow:
	rm -rf $(STALE:%=$(BUILD)/lib/glibc-hwcaps/%) $(STALE:%=$(BUILD)/lib/povtrace/primitives/%)
endif

# ---- programs ----

$(BUILD)/obj/cli/%.o: cli/%.c
	@mkdir -p $(@D)
	$(CC) $(USER_FLAGS) -Icli -c $< -o $@

$(POVC): $(CLI_OBJECTS) $(SHARED) | $(WIDE_SHARED) $(WIDE_PLUGINS)
	@mkdir -p $(@D)
	$(CC) $(LINK_FLAGS) $(CLI_OBJECTS) -L$(BUILD)/lib -lpovtrace -Wl,-rpath,'$$ORIGIN/../lib' -lm -o $@

# Objects are kept, also those that only a chain of rules made.
.SECONDARY:

-include viewer/viewer.mk
include tests/tests.mk

# ---- install ----

BINDIR        ?= $(PREFIX)/bin
INCLUDEDIR    ?= $(PREFIX)/include
MANDIR        ?= $(PREFIX)/share/man
COMPLETIONDIR ?= $(PREFIX)/share/bash-completion/completions
INSTALL       ?= install
PUBLIC_HEADERS = $(sort $(wildcard lib/include/povtrace/*.h))

# From the program to the library and from the CMake package to the headers, so that the installed tree may be moved;
# a library outside the prefix is named in full.
BELOW_PREFIX = $(patsubst $(PREFIX)/%,%,$(LIBDIR))
EMPTY :=
UP_TO_PREFIX = $(subst $(EMPTY) ,/,$(patsubst %,..,$(subst /, ,$(BELOW_PREFIX))))
ifeq ($(BINDIR) $(INCLUDEDIR) $(LIBDIR),$(PREFIX)/bin $(PREFIX)/include $(filter $(PREFIX)/%,$(LIBDIR)))
INSTALL_RPATH    = $$ORIGIN/../$(BELOW_PREFIX)
CMAKE_INCLUDEDIR = $${_povtrace_libdir}/$(UP_TO_PREFIX)/include
else
INSTALL_RPATH    = $(LIBDIR)
CMAKE_INCLUDEDIR = $(INCLUDEDIR)
endif

FILL_IN = sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@LIBDIR@|$(LIBDIR)|' -e 's|@INCLUDEDIR@|$(INCLUDEDIR)|' \
          -e 's|@VERSION@|$(VERSION)|' -e 's|@SOVERSION@|$(SOVERSION)|' -e 's|@CMAKE_INCLUDEDIR@|$(CMAKE_INCLUDEDIR)|'

# The library knows the folder of installed plugins by name, as the last place to look: another folder, another object.
.PHONY: FORCE
$(BUILD)/libdir: FORCE
	@mkdir -p $(@D)
	@echo '$(LIBDIR)' | cmp -s - $@ || echo '$(LIBDIR)' > $@
$(BUILD)/obj/lib/plug/registry.o $(WIDE:%=$(BUILD)/obj/%/lib/plug/registry.o): $(BUILD)/libdir

# $(1): the processors.
define INSTALL_WIDE
	$(INSTALL) -d $(DESTDIR)$(LIBDIR)/glibc-hwcaps/$(1) $(DESTDIR)$(LIBDIR)/povtrace/primitives/$(1)
	$(INSTALL) -m 755 $(BUILD)/lib/glibc-hwcaps/$(1)/libpovtrace.so.$(VERSION) $(DESTDIR)$(LIBDIR)/glibc-hwcaps/$(1)
	ln -sf libpovtrace.so.$(VERSION) $(DESTDIR)$(LIBDIR)/glibc-hwcaps/$(1)/libpovtrace.so.$(SOVERSION)
	$(INSTALL) -m 755 $(filter $(BUILD)/lib/povtrace/primitives/$(1)/%,$(WIDE_PLUGINS)) $(DESTDIR)$(LIBDIR)/povtrace/primitives/$(1)

endef

.PHONY: install uninstall
install: all
	$(INSTALL) -d $(addprefix $(DESTDIR),$(BINDIR) $(INCLUDEDIR)/povtrace $(LIBDIR)/pkgconfig $(LIBDIR)/cmake/povtrace \
	    $(LIBDIR)/povtrace/primitives $(LIBDIR)/povtrace/images $(LIBDIR)/povtrace/plots $(MANDIR)/man1 $(MANDIR)/man3 $(COMPLETIONDIR))
	$(INSTALL) -m 644 $(PUBLIC_HEADERS) $(DESTDIR)$(INCLUDEDIR)/povtrace
	$(INSTALL) -m 755 $(SHARED) $(DESTDIR)$(LIBDIR)
	ln -sf $(notdir $(SHARED)) $(DESTDIR)$(LIBDIR)/libpovtrace.so.$(SOVERSION)
	ln -sf libpovtrace.so.$(SOVERSION) $(DESTDIR)$(LIBDIR)/libpovtrace.so
	$(INSTALL) -m 644 $(STATIC) $(DESTDIR)$(LIBDIR)
	$(INSTALL) -m 755 $(PRIMITIVES) $(DESTDIR)$(LIBDIR)/povtrace/primitives
	$(INSTALL) -m 755 $(IMAGES) $(DESTDIR)$(LIBDIR)/povtrace/images
	$(if $(PLOTS),$(INSTALL) -m 755 $(PLOTS) $(DESTDIR)$(LIBDIR)/povtrace/plots)
	$(foreach w,$(WIDE),$(call INSTALL_WIDE,$(w)))
	@mkdir -p $(BUILD)/install
	$(CC) $(LINK_FLAGS) $(CLI_OBJECTS) -L$(BUILD)/lib -lpovtrace -Wl,-rpath,'$(INSTALL_RPATH)' -lm \
	    -o $(BUILD)/install/povc
	$(INSTALL) -m 755 $(BUILD)/install/povc $(DESTDIR)$(BINDIR)
	$(FILL_IN) lib/povtrace.pc.in > $(DESTDIR)$(LIBDIR)/pkgconfig/povtrace.pc
	$(FILL_IN) lib/povtraceConfig.cmake.in > $(DESTDIR)$(LIBDIR)/cmake/povtrace/povtraceConfig.cmake
	$(FILL_IN) lib/povtraceConfigVersion.cmake.in > $(DESTDIR)$(LIBDIR)/cmake/povtrace/povtraceConfigVersion.cmake
	$(INSTALL) -m 644 docs/man/povc.1 $(DESTDIR)$(MANDIR)/man1
	$(INSTALL) -m 644 docs/man/povtrace.3 $(DESTDIR)$(MANDIR)/man3
	$(INSTALL) -m 644 cli/povc.bash $(DESTDIR)$(COMPLETIONDIR)/povc

# What install put there and nothing else; folders that others use stay.
uninstall:
	rm -f $(DESTDIR)$(BINDIR)/povc $(DESTDIR)$(MANDIR)/man1/povc.1 $(DESTDIR)$(MANDIR)/man3/povtrace.3 \
	    $(DESTDIR)$(COMPLETIONDIR)/povc $(DESTDIR)$(LIBDIR)/libpovtrace.so $(DESTDIR)$(LIBDIR)/libpovtrace.a \
	    $(DESTDIR)$(LIBDIR)/libpovtrace.so.$(SOVERSION) $(DESTDIR)$(LIBDIR)/libpovtrace.so.$(VERSION) \
	    $(DESTDIR)$(LIBDIR)/pkgconfig/povtrace.pc \
	    $(addprefix $(DESTDIR)$(LIBDIR)/cmake/povtrace/,povtraceConfig.cmake povtraceConfigVersion.cmake) \
	    $(patsubst $(BUILD)/lib/%,$(DESTDIR)$(LIBDIR)/%,$(PLUGINS) $(WIDE_PLUGINS) $(WIDE_SHARED)) \
	    $(WIDE:%=$(DESTDIR)$(LIBDIR)/glibc-hwcaps/%/libpovtrace.so.$(SOVERSION)) \
	    $(addprefix $(DESTDIR)$(INCLUDEDIR)/povtrace/,$(notdir $(PUBLIC_HEADERS)))
	-rmdir $(addprefix $(DESTDIR),$(if $(WIDE),$(WIDE:%=$(LIBDIR)/glibc-hwcaps/%) $(LIBDIR)/glibc-hwcaps \
	    $(WIDE:%=$(LIBDIR)/povtrace/primitives/%)) $(LIBDIR)/povtrace/primitives $(LIBDIR)/povtrace/images $(LIBDIR)/povtrace/plots $(LIBDIR)/povtrace \
	    $(LIBDIR)/cmake/povtrace $(INCLUDEDIR)/povtrace)

# ---- first steps ----

.PHONY: deps demo check help clean
deps:
	@CC='$(CC)' CXX='$(CXX)' PYTHON='$(PYTHON)' PKG_CONFIG='$(PKG_CONFIG)' .ci/deps test

DEMO      ?= sphereflake
DEMO_SIZE ?= 800 600

demo:
	@CC='$(CC)' PKG_CONFIG='$(PKG_CONFIG)' .ci/deps build
	@$(MAKE) --no-print-directory all
	@mkdir -p $(BUILD)/demo
	$(POVC) scenes/gallery/$(DEMO).pov $(DEMO_SIZE) $(BUILD)/demo/$(DEMO).png --spp 4
	@echo
	@echo "The picture is in $(BUILD)/demo/$(DEMO).png. What to try next:"
	@echo "  make demo DEMO=NAME      for another scene of scenes/gallery: $(notdir $(basename $(wildcard scenes/gallery/*.pov)))"
	@echo "  $(POVC) SCENE.pov 1024 768 OUT.png       for a scene of your own; $(POVC) --help says more"
	@echo "  $(POVC) --explain scenes/gallery/$(DEMO).pov    for what the scene needs and what was left out"

check: $(SHARED) $(PLUGINS)
	@BUILD='$(BUILD)' CC='$(CC)' CXX='$(CXX)' tests/check/check.sh

help:
	@echo "make            build the library, the plugins and povc into $(BUILD)/"
	@echo "make demo       render a scene of the gallery and say where the picture is"
	@echo "make test       run every test"
	@echo "make check      hold the tree to its rules: rooms, exports, headers alone, no absolute epsilons"
	@echo "make asan tsan  run the tests under the sanitizers"
	@echo "make compare    hold the pictures against POV-Ray's, where it is installed"
	@echo "make validate-error   hold what povc says of its error against the truth; an hour or more the first time"
	@echo "make bench      time povc against POV-Ray, Tachyon and Embree; bench-counts: its instructions a ray, bench-whole:"
	@echo "                whole processes, bench-threads, bench-scale: threads and objects, bench-bits: the same to the bit"
	@echo "make deps       install what is missing to build and test, by the system's package manager"
	@echo "make install    to PREFIX ($(PREFIX)), below DESTDIR if given; make uninstall takes it away again"
	@echo "make clean      remove $(BUILD)/"
	@echo
	@echo "BUILD=, CC=, CFLAGS=, OPTIMISE=, SANITIZE=, PREFIX=, LIBDIR= are as usual; WIDE= leaves out the builds"
	@echo "of the library and the primitives for x86-64-v3 and x86-64-v4 processors."

clean:
	rm -rf $(BUILD)

-include $(shell find $(BUILD)/obj -name '*.d' 2>/dev/null)
