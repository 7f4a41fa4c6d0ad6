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
OPTIMISE ?= -O2
SANITIZE ?=
WERROR   ?=
PKG_CONFIG ?= pkg-config

WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wpointer-arith \
           -Wwrite-strings -Wvla -Wundef $(WERROR)
# Contraction would make the bits of a result depend on the machine.
CFLAGS  ?= -g
BASE_FLAGS = -std=c99 -D_POSIX_C_SOURCE=200809L $(OPTIMISE) -ffp-contract=off -fno-math-errno -fPIC \
             -fvisibility=hidden -MMD -MP $(WARNINGS) $(CFLAGS) $(SANITIZE)
LIB_FLAGS  = $(BASE_FLAGS) -Ilib/include -Ilib -DPOV_PLUGIN_DIR='"$(LIBDIR)/povtrace"'
USER_FLAGS = $(BASE_FLAGS) -Ilib/include
LINK_FLAGS = $(LDFLAGS) $(SANITIZE) $(OPTIMISE)
SYSTEM_LIBS = -lm -ldl -lpthread

LIB_SOURCES    = $(sort $(wildcard lib/*/*.c))
LIB_OBJECTS    = $(LIB_SOURCES:%.c=$(BUILD)/obj/%.o)
KIT_OBJECTS    = $(patsubst %.c,$(BUILD)/obj/%.o,$(sort $(wildcard plugins/kit/*.c)))
PRIMITIVES     = $(patsubst plugins/%.c,$(BUILD)/lib/povtrace/%.so,$(sort $(wildcard plugins/primitives/*.c)))
IMAGES         = $(patsubst plugins/%.c,$(BUILD)/lib/povtrace/%.so,$(sort $(wildcard plugins/images/*.c)))
PLUGINS        = $(PRIMITIVES) $(IMAGES)
CLI_OBJECTS    = $(patsubst %.c,$(BUILD)/obj/%.o,$(sort $(wildcard cli/*.c)))
SHARED         = $(BUILD)/lib/libpovtrace.so.$(VERSION)
STATIC         = $(BUILD)/lib/libpovtrace.a
POVC           = $(BUILD)/bin/povc

.PHONY: all
all: $(SHARED) $(STATIC) $(PLUGINS) $(POVC)

# ---- the library ----

$(BUILD)/obj/lib/%.o: lib/%.c
	@mkdir -p $(@D)
	$(CC) $(LIB_FLAGS) -c $< -o $@

$(STATIC): $(LIB_OBJECTS)
	@mkdir -p $(@D)
	rm -f $@
	ar rcs $@ $^

$(SHARED): $(LIB_OBJECTS) lib/api/libpovtrace.map
	@mkdir -p $(@D)
	$(CC) -shared -Wl,-soname,libpovtrace.so.$(SOVERSION) -Wl,--version-script,lib/api/libpovtrace.map \
	    -Wl,--no-undefined $(LINK_FLAGS) $(LIB_OBJECTS) $(SYSTEM_LIBS) -o $@
	ln -sf $(@F) $(@D)/libpovtrace.so.$(SOVERSION)
	ln -sf libpovtrace.so.$(SOVERSION) $(@D)/libpovtrace.so

# ---- plugins: a file each, linked against nothing of povtrace ----

$(BUILD)/obj/plugins/%.o: plugins/%.c
	@mkdir -p $(@D)
	$(CC) $(USER_FLAGS) -Iplugins -c $< -o $@

$(BUILD)/obj/plugins/images/png.o: USER_FLAGS += $(shell $(PKG_CONFIG) --cflags libpng)
$(BUILD)/lib/povtrace/images/png.so: PLUGIN_LIBS = $(shell $(PKG_CONFIG) --libs libpng)

$(BUILD)/lib/povtrace/%.so: $(BUILD)/obj/plugins/%.o $(KIT_OBJECTS)
	@mkdir -p $(@D)
	$(CC) -shared -Wl,--no-undefined -Wl,--gc-sections -Wl,--as-needed $(LINK_FLAGS) $^ $(PLUGIN_LIBS) -lm -o $@

# ---- programs ----

$(BUILD)/obj/cli/%.o: cli/%.c
	@mkdir -p $(@D)
	$(CC) $(USER_FLAGS) -Icli -c $< -o $@

$(POVC): $(CLI_OBJECTS) $(SHARED)
	@mkdir -p $(@D)
	$(CC) $(LINK_FLAGS) $(CLI_OBJECTS) -L$(BUILD)/lib -lpovtrace -Wl,-rpath,'$$ORIGIN/../lib' -lm -o $@

-include $(shell find $(BUILD)/obj -name '*.d' 2>/dev/null)
include tests/tests.mk

.PHONY: clean
clean:
	rm -rf $(BUILD)
