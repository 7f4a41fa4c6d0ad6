# povtrace. `make demo` shows what it does, `make test` proves it; `make help` lists the rest.
VERSION   = 0.1.0
SOVERSION = 0
BUILD    ?= build
PREFIX   ?= /usr/local
DESTDIR  ?=
LIBDIR   ?= $(PREFIX)/lib
SHAREDIR ?= $(PREFIX)/share/povtrace
CC       ?= cc
CXX      ?= c++
PYTHON   ?= python3
OPTIMISE ?= -O3
SANITIZE ?=
WERROR   ?=
PKG_CONFIG ?= pkg-config
# The library and the primitives are built once more for these processors, beside the baseline; the system's loader
# picks, and the pictures are the same bit for bit. WIDE= leaves that out.
WIDE     ?= $(if $(SANITIZE),,$(shell for w in x86-64-v3 x86-64-v4; do \
               $(CC) -march=$$w -dM -E -x c /dev/null 2>/dev/null | grep -q __gnu_linux__ && echo $$w; done))
WIDE     := $(WIDE)

# A line for each file that is made; V=1 shows the commands.
V        ?=
SILENT   := $(findstring s,$(firstword -$(MAKEFLAGS)))
# A job for each core, unless -j says otherwise, here or in the environment; one after the other where a goal makes or removes what others read.
ifeq ($(MAKELEVEL),0)
ifeq ($(filter -j% j%,$(shell echo "$$MAKEFLAGS")),)
MAKEFLAGS += -j$(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
endif
ifneq ($(and $(filter clean deps test demo asan tsan ubsan,$(MAKECMDGOALS)),$(word 2,$(MAKECMDGOALS))),)
.NOTPARALLEL:
endif
endif

WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wpointer-arith \
           -Wwrite-strings -Wvla -Wundef $(WERROR)
# Contraction would make the bits of a result depend on the machine. Nobody reads floating-point traps or errno, and
# loops over lanes become vectors only without them.
CFLAGS  ?= -g
BASE_FLAGS = -std=c99 -D_POSIX_C_SOURCE=200809L $(OPTIMISE) -ffp-contract=off -fno-math-errno -fno-trapping-math -fPIC \
             -ffunction-sections -fvisibility=hidden -MMD -MP $(WARNINGS) $(CFLAGS) $(SANITIZE) -Ilib/include
LINK_FLAGS = $(LDFLAGS) $(SANITIZE) $(OPTIMISE)
SYSTEM_LIBS = -lm -ldl -lpthread

LIB_SOURCES   := $(sort $(wildcard lib/*/*.c))
COMMON_SOURCES   := $(sort $(wildcard plugins/common/*.c))
CLI_OBJECTS    = $(patsubst %.c,$(BUILD)/obj/%.o,$(sort $(wildcard cli/*.c)))
# What a folder's plugins are called where they are built.
plugins_of     = $(patsubst plugins/%.c,$(BUILD)/lib/povtrace/%.so,$(sort $(wildcard plugins/$(1)/*.c)))
PRIMITIVES     = $(filter-out $(PRIMITIVES_MISSING),$(call plugins_of,primitives))
# Texts and some formats of pictures need a library, plots need cairo; without them all else is built.
NEEDS_text     = freetype2
NEEDS_png      = libpng
NEEDS_jpeg     = libjpeg
NEEDS_tiff     = libtiff-4 >= 4.5
NEEDS_exr      = OpenEXR >= 3.1
IMAGES_MISSING := $(foreach f,png jpeg tiff exr,$(shell $(PKG_CONFIG) --exists '$(NEEDS_$(f))' || echo $(f)))
PRIMITIVES_MISSING := $(shell $(PKG_CONFIG) --exists $(NEEDS_text) || echo %/text.so)
IMAGES         = $(filter-out $(foreach f,$(IMAGES_MISSING),%/$(f).so),$(call plugins_of,images))
PLOTS         := $(shell $(PKG_CONFIG) --exists cairo-svg cairo-png && echo $(call plugins_of,plots))
PLUGINS        = $(PRIMITIVES) $(IMAGES) $(PLOTS)
# Include files of the scene language, where the library looks for them.
INCLUDES      := $(sort $(wildcard share/povtrace/include/*.inc))
SHARED         = $(BUILD)/lib/libpovtrace.so.$(VERSION)
STATIC         = $(BUILD)/lib/libpovtrace.a
POVC           = $(BUILD)/bin/povc
# Of what is WIDE, where the loader and the library look for it.
WIDE_SHARED    = $(WIDE:%=$(BUILD)/lib/glibc-hwcaps/%/libpovtrace.so.$(VERSION))
WIDE_PLUGINS   = $(foreach w,$(WIDE),$(PRIMITIVES:$(BUILD)/lib/povtrace/primitives/%=$(BUILD)/lib/povtrace/primitives/$(w)/%))

# What povc needs to run; all is that and the static library.
.PHONY: all runtime
all: runtime $(STATIC)
runtime: $(SHARED) $(PLUGINS) $(WIDE_SHARED) $(WIDE_PLUGINS) $(POVC) $(INCLUDES:%=$(BUILD)/%)
$(BUILD)/share/%: share/%
	@mkdir -p $(@D)
	@cp $< $@
ifneq ($(PRIMITIVES_MISSING),)
runtime: no-text
.PHONY: no-text
no-text:
	@echo "text { } was left out: pkg-config does not find $(NEEDS_text)"
endif
ifneq ($(IMAGES_MISSING),)
runtime: $(IMAGES_MISSING:%=no-%)
.PHONY: $(IMAGES_MISSING:%=no-%)
$(IMAGES_MISSING:%=no-%): no-%:
	@echo "pictures in $(shell echo $* | tr a-z A-Z) were left out: pkg-config does not find $(NEEDS_$*)"
endif

.PHONY: dev
dev:
	@$(MAKE) --no-print-directory BUILD=$(BUILD)-dev WIDE= OPTIMISE=-O2 runtime

# ---- how things are made: rooms have ROOM_FLAGS, some plugins PLUGIN_LIBS, programs PROGRAM_LIBS ----

# What a recipe begins with; $(1): the word, $(2): what it is for.
say     = $(if $(filter-out 0,$(V)),,@$(if $(SILENT),,echo $(1) $(2) &&)) mkdir -p $(@D) &&
COMPILE = $(call say,CC,$< $(COPY)) $(CC) $(BASE_FLAGS) $(COPY_FLAGS) $(ROOM_FLAGS) -c $< -o $@
ARCHIVE = $(call say,AR,$@) rm -f $@ && $(AR) rcs $@ $(filter %.o,$^)
LINK_SHARED = $(call say,LINK,$@) $(CC) -shared -Wl,-soname,libpovtrace.so.$(SOVERSION) \
              -Wl,--version-script,lib/api/libpovtrace.map -Wl,--no-undefined $(LINK_FLAGS) $(filter %.o,$^) $(SYSTEM_LIBS) -o $@ && \
              ln -sf $(@F) $(@D)/libpovtrace.so.$(SOVERSION) && ln -sf libpovtrace.so.$(SOVERSION) $(@D)/libpovtrace.so
LINK_PLUGIN = $(call say,LINK,$@) $(CC) -shared -Wl,--no-undefined -Wl,--gc-sections -Wl,--as-needed $(LINK_FLAGS) $^ \
              $(PLUGIN_LIBS) -lm -o $@
# $(1): where the program finds the shared library.
LINK_PROGRAM = $(call say,LINK,$@) $(CC) $(LINK_FLAGS) $(filter %.o,$^) -L$(BUILD)/lib -lpovtrace -Wl,-rpath,'$(1)' \
              $(PROGRAM_LIBS) -lm -o $@

# ---- the library and the primitives, a copy for each kind of processor ----

# Sums and products of 512 bits take a tenth less time on AMD's Zen 5. On servers of Intel's that lower their clock for them,
# WIDE_BITS=256 is the faster one. The bits of pictures are the same.
WIDE_BITS ?= 512
WIDE_FLAGS_x86-64-v4 = -mprefer-vector-width=$(WIDE_BITS) $(if $(filter 512,$(WIDE_BITS)),,-DPOV_NARROW)

# $(1): the copy's folder below obj, with its slash: none for the baseline.
define COPY_RULES
$(BUILD)/obj/$(1)%.o: COPY = $(1:/=)
$(BUILD)/obj/$(1)%.o: COPY_FLAGS = $(if $(1),-march=$(1:/=) $(WIDE_FLAGS_$(1:/=)) -DPOV_WIDE='"$(1:/=)"')
$(BUILD)/obj/$(1)lib/%.o: ROOM_FLAGS = -Ilib -DPOV_PLUGIN_DIR='"$(LIBDIR)/povtrace"' \
    -DPOV_SHARE_DIR='"$(SHAREDIR)"'
$(BUILD)/obj/$(1)plugins/%.o: ROOM_FLAGS = -Iplugins -Ilib
$(BUILD)/obj/$(1)plugins/primitives/text.o: ROOM_FLAGS += $$(shell $$(PKG_CONFIG) --cflags $$(NEEDS_text))
$(BUILD)/lib/povtrace/primitives/$(1)text.so: PLUGIN_LIBS = $$(shell $$(PKG_CONFIG) --libs $$(NEEDS_text))
$(BUILD)/obj/$(1)%.o: %.c
	$$(COMPILE)

$(BUILD)/lib/$(if $(1),glibc-hwcaps/)$(1)libpovtrace.so.$(VERSION): $(LIB_SOURCES:%.c=$(BUILD)/obj/$(1)%.o) lib/api/libpovtrace.map
	$$(LINK_SHARED)
$(BUILD)/lib/$(1)libpovtrace.a: $(LIB_SOURCES:%.c=$(BUILD)/obj/$(1)%.o)
	$$(ARCHIVE)

# Plugins are a file each, linked against nothing of povtrace.
$(BUILD)/obj/$(1)plugins/common.a: $(COMMON_SOURCES:%.c=$(BUILD)/obj/$(1)%.o)
	$$(ARCHIVE)
$(BUILD)/lib/povtrace/primitives/$(1)%.so: $(BUILD)/obj/$(1)plugins/primitives/%.o $(BUILD)/obj/$(1)plugins/common.a
	$$(LINK_PLUGIN)
endef
# The baseline's folder is none.
$(eval $(call COPY_RULES,))
$(foreach w,$(WIDE),$(eval $(call COPY_RULES,$(w)/)))

# ---- the other plugins ----

$(BUILD)/lib/povtrace/%.so: $(BUILD)/obj/plugins/%.o $(BUILD)/obj/plugins/common.a
	$(LINK_PLUGIN)

# $(1): a format that needs a library.
define IMAGE_RULES
$(BUILD)/obj/plugins/images/$(1).o: ROOM_FLAGS += $$(patsubst -I%,-isystem %,$$(shell $$(PKG_CONFIG) --cflags '$$(NEEDS_$(1))'))
$(BUILD)/lib/povtrace/images/$(1).so: PLUGIN_LIBS = $$(shell $$(PKG_CONFIG) --libs '$$(NEEDS_$(1))')
endef
$(foreach f,png jpeg tiff exr,$(eval $(call IMAGE_RULES,$(f))))

$(BUILD)/obj/plugins/plots/plot.o: ROOM_FLAGS += $(shell $(PKG_CONFIG) --cflags cairo)
# Cairo and what it stands on keep caches for ever: unloaded and loaded again, they would leak them each time.
$(BUILD)/lib/povtrace/plots/plot.so: PLUGIN_LIBS = $(shell $(PKG_CONFIG) --libs cairo) -Wl,-z,nodelete

# The loader would take what an earlier make left.
STALE := $(filter-out $(WIDE),$(notdir $(wildcard $(BUILD)/lib/glibc-hwcaps/*)))
ifneq ($(STALE),)
.PHONY: narrow
runtime: narrow
narrow:
	rm -rf $(STALE:%=$(BUILD)/lib/glibc-hwcaps/%) $(STALE:%=$(BUILD)/lib/povtrace/primitives/%)
endif

# ---- programs: what takes time is in the library, and gcc 12 fails on one of cli's files for aarch64 at -O3 ----

$(BUILD)/obj/cli/%.o $(BUILD)/obj/viewer/%.o: OPTIMISE = -O2
$(BUILD)/obj/cli/%.o: ROOM_FLAGS = -Icli
$(POVC): $(CLI_OBJECTS) $(SHARED) | $(WIDE_SHARED) $(WIDE_PLUGINS)
	$(call LINK_PROGRAM,$$ORIGIN/../lib)

# Objects are kept, also those that only a chain of rules made.
.SECONDARY:

-include viewer/viewer.mk
include tests/tests.mk

# ---- install ----

BINDIR        ?= $(PREFIX)/bin
INCLUDEDIR    ?= $(PREFIX)/include
MANDIR        ?= $(PREFIX)/share/man
COMPLETIONDIR ?= $(PREFIX)/share/bash-completion/completions
ZSHDIR        ?= $(PREFIX)/share/zsh/site-functions
FISHDIR       ?= $(PREFIX)/share/fish/vendor_completions.d
INSTALL       ?= install
DOCDIR        ?= $(PREFIX)/share/doc/povtrace
DOC_PAGES      = README.md LICENSE $(sort $(wildcard docs/*.md))
DOC_SCENES     = $(sort $(wildcard scenes/gallery/*.pov))
DOC_PICTURES   = $(sort $(wildcard docs/images/*.png docs/images/*.svg))
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

# The library knows the folders of installed plugins and include files by name, as the last place to look: another
# folder, another object.
.PHONY: FORCE
$(BUILD)/libdir: FORCE
	@mkdir -p $(@D)
	@echo '$(LIBDIR) $(SHAREDIR)' | cmp -s - $@ || echo '$(LIBDIR) $(SHAREDIR)' > $@
$(foreach o,plug/registry.o sdl/include.o,$(BUILD)/obj/lib/$o $(WIDE:%=$(BUILD)/obj/%/lib/$o)): $(BUILD)/libdir

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
	    $(LIBDIR)/povtrace/primitives $(LIBDIR)/povtrace/images $(LIBDIR)/povtrace/plots $(MANDIR)/man1 $(MANDIR)/man3 $(COMPLETIONDIR) $(ZSHDIR) $(FISHDIR) \
	    $(SHAREDIR)/include)
	$(INSTALL) -m 644 $(INCLUDES) $(DESTDIR)$(SHAREDIR)/include
	$(INSTALL) -d $(addprefix $(DESTDIR)$(DOCDIR)/,docs/images scenes/gallery)
	$(INSTALL) -m 644 $(filter-out docs/%,$(DOC_PAGES)) $(DESTDIR)$(DOCDIR)
	$(INSTALL) -m 644 $(filter docs/%,$(DOC_PAGES)) $(DESTDIR)$(DOCDIR)/docs
	$(INSTALL) -m 644 $(DOC_PICTURES) $(DESTDIR)$(DOCDIR)/docs/images
	$(INSTALL) -m 644 $(DOC_SCENES) $(DESTDIR)$(DOCDIR)/scenes/gallery
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
	$(INSTALL) -m 644 share/completions/povc.bash $(DESTDIR)$(COMPLETIONDIR)/povc
	$(INSTALL) -m 644 share/completions/_povc $(DESTDIR)$(ZSHDIR)
	$(INSTALL) -m 644 share/completions/povc.fish $(DESTDIR)$(FISHDIR)

# What install put there and nothing else; folders that others use stay.
uninstall:
	rm -f $(DESTDIR)$(BINDIR)/povc $(DESTDIR)$(MANDIR)/man1/povc.1 $(DESTDIR)$(MANDIR)/man3/povtrace.3 \
	    $(DESTDIR)$(COMPLETIONDIR)/povc $(DESTDIR)$(ZSHDIR)/_povc $(DESTDIR)$(FISHDIR)/povc.fish $(DESTDIR)$(LIBDIR)/libpovtrace.so $(DESTDIR)$(LIBDIR)/libpovtrace.a \
	    $(DESTDIR)$(LIBDIR)/libpovtrace.so.$(SOVERSION) $(DESTDIR)$(LIBDIR)/libpovtrace.so.$(VERSION) \
	    $(DESTDIR)$(LIBDIR)/pkgconfig/povtrace.pc \
	    $(addprefix $(DESTDIR)$(LIBDIR)/cmake/povtrace/,povtraceConfig.cmake povtraceConfigVersion.cmake) \
	    $(patsubst $(BUILD)/lib/%,$(DESTDIR)$(LIBDIR)/%,$(PLUGINS) $(WIDE_PLUGINS) $(WIDE_SHARED)) \
	    $(WIDE:%=$(DESTDIR)$(LIBDIR)/glibc-hwcaps/%/libpovtrace.so.$(SOVERSION)) \
	    $(addprefix $(DESTDIR)$(INCLUDEDIR)/povtrace/,$(notdir $(PUBLIC_HEADERS))) \
	    $(addprefix $(DESTDIR)$(SHAREDIR)/include/,$(notdir $(INCLUDES))) \
	    $(addprefix $(DESTDIR)$(DOCDIR)/,$(DOC_PAGES) $(DOC_PICTURES) $(DOC_SCENES))
	-rmdir $(addprefix $(DESTDIR),$(if $(WIDE),$(WIDE:%=$(LIBDIR)/glibc-hwcaps/%) $(LIBDIR)/glibc-hwcaps \
	    $(WIDE:%=$(LIBDIR)/povtrace/primitives/%)) $(LIBDIR)/povtrace/primitives $(LIBDIR)/povtrace/images $(LIBDIR)/povtrace/plots $(LIBDIR)/povtrace \
	    $(LIBDIR)/cmake/povtrace $(INCLUDEDIR)/povtrace $(SHAREDIR)/include $(SHAREDIR) \
	    $(DOCDIR)/docs/images $(DOCDIR)/docs $(DOCDIR)/scenes/gallery $(DOCDIR)/scenes $(DOCDIR))

# ---- first steps ----

.PHONY: deps demo check help clean
deps:
	@CC='$(CC)' CXX='$(CXX)' PYTHON='$(PYTHON)' PKG_CONFIG='$(PKG_CONFIG)' .ci/deps test

DEMO      ?= pool
DEMO_SIZE ?= 800 600
DEMO_SCENE = scenes/gallery/$(DEMO).pov
DEMO_VIEW  = $(BUILD)/bin/povview $(DEMO_SCENE)

# Make is called anew for what is built to be decided by what was installed.
demo:
	@CC='$(CC)' PKG_CONFIG='$(PKG_CONFIG)' .ci/deps build
	@$(MAKE) --no-print-directory all
	@mkdir -p $(BUILD)/demo
	$(POVC) $(DEMO_SCENE) $(DEMO_SIZE) $(BUILD)/demo/$(DEMO).png --spp 9
	@echo
	@echo "The picture is in $(BUILD)/demo/$(DEMO).png. What to try next:"
	@if [ ! -x $(BUILD)/bin/povview ]; then :; elif [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ]; then \
	    echo "  $(DEMO_VIEW)    to walk about in it; H shows the keys"; else \
	    echo "  $(DEMO_VIEW) 800 600 --shot $(BUILD)/demo/window.png    for what the viewer's window shows; there is no display here"; fi
	@echo "  make demo DEMO=NAME    for another scene of scenes/gallery: $(notdir $(basename $(wildcard scenes/gallery/*.pov)))"
	@echo "  $(POVC) SCENE.pov 1024 768 OUT.png    for a scene of your own; $(POVC) --help says more"
	@echo "  $(POVC) --explain $(DEMO_SCENE)    for what the scene needs and what was left out"

check: $(SHARED) $(PLUGINS)
	@BUILD='$(BUILD)' CC='$(CC)' CXX='$(CXX)' tests/check/check.sh

help:
	@echo "make            build $(BUILD)/bin/povc and $(BUILD)/bin/povview, the library and the plugins"
	@echo "make dev        build povc and what it loads into $(BUILD)-dev/, one copy at -O2: for edit and try"
	@echo "make demo       install what is missing, build, render a scene of the gallery and say what to try next"
	@echo "make test       run every test"
	@echo "make check      hold the tree to its rules: rooms, exports, headers alone, no absolute epsilons"
	@echo "make asan tsan  run the tests under the sanitizers; asan under clang's as well, where it is: make ubsan"
	@echo "make aarch64    build for aarch64 with Debian's cross compiler; hold its pictures, by qemu, against this machine's"
	@echo "make compare    hold the pictures against POV-Ray's, where it is installed"
	@echo "make fuzz       give strangers' bytes to scenes, images, checkpoints and arguments: SECONDS=n each; wants clang"
	@echo "make mutate     make a dozen mistakes in a copy of the tree, one by one: a test must notice each"
	@echo "make corpus     draw the scenes that come with POV-Ray beside it: what is read, what matches, what is missing"
	@echo "                corpus-bits: by threads, tree and copies the same bits; corpus-asan: under the sanitizers"
	@echo "make programs   the same with scenes that ASE, PyMOL, VTK, vapory, Jmol, Open Babel and Inkscape write"
	@echo "make validate-error   hold what povc says of its error against the truth; an hour or more the first time"
	@echo "make bench      time povc against POV-Ray, Tachyon and Embree; bench-counts: its instructions a ray, bench-whole:"
	@echo "                whole processes, bench-threads, bench-scale: threads and objects, bench-bits: the same bit for bit"
	@echo "make deps       install what is missing to build and test, by the system's package manager"
	@echo "make install    to PREFIX ($(PREFIX)), below DESTDIR if given; make uninstall takes it away again"
	@echo "make clean      remove $(BUILD)/"
	@echo
	@echo "BUILD=, CC=, CFLAGS=, OPTIMISE=, SANITIZE=, PREFIX=, LIBDIR= are as usual; WIDE= leaves out the builds"
	@echo "of the library and the primitives for x86-64-v3 and x86-64-v4 processors; V=1 shows the commands."

clean:
	rm -rf $(BUILD) $(BUILD)-dev $(BUILD)-aarch64

-include $(shell find $(BUILD)/obj -name '*.d' 2>/dev/null)
