/* GCC 12's static libstdc++ reads this variable of glibc 2.32, to leave locks out while there is one thread. Older
   glibcs lack it: false means that there may be more. */
__attribute__((visibility("hidden"))) char __libc_single_threaded;
