// SPDX-License-Identifier: GPL-3.0-or-later
// What the leak check of the address sanitizer is told when windows are tested. Libraries that a
// window brings with it keep a few blocks for as long as the program runs.
#if defined(__SANITIZE_ADDRESS__)

// A library that is unloaded before the check has no name any more by which to be told apart, so
// none is. Called by the loader's users by name, never by this project.
extern "C" int dlclose(void*) { return 0; }

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libdbus-1.so\n"
           "leak:libGLX_mesa.so\n"
           "leak:libgallium\n"
           "leak:swrast_dri.so\n"
           "leak:libfontconfig.so\n";
}

#endif
