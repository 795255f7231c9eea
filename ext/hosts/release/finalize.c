/* Runs the destructors of the module's globals when it is unloaded. A compiler's start files usually do so; zig links
   shared objects for glibc without them, and the process would call the destructors at its exit, after their code has
   been unmapped. */
extern void* __dso_handle;
extern void __cxa_finalize(void*);

__attribute__((destructor)) static void finalize(void) {
  __cxa_finalize(&__dso_handle);
}
