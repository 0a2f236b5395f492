// What takes the place of functions within Debian's Paho C 1.3.12: the linker leads its calls of
// NAME to __wrap_NAME, and __real_NAME to what was called before (--wrap).
#include <openssl/ssl.h>

#include <cstddef>
#include <cstdlib>

// NOLINTBEGIN(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp): the linker's names
// NOLINTBEGIN(cppcoreguidelines-no-malloc): their signatures are Paho's
extern "C" {

// ---- no records of calls and of memory: what Paho's build option PAHO_HIGH_PERFORMANCE leaves out

void __wrap_StackTrace_entry(const char*, int, int) {}
void __wrap_StackTrace_exit(const char*, int, void*, int) {}
void* __wrap_mymalloc(const char*, int, std::size_t size) {
  return std::malloc(size);
}
void* __wrap_myrealloc(const char*, int, void* memory, std::size_t size) {
  return std::realloc(memory, size);
}
void __wrap_myfree(const char*, int, void* memory) {
  std::free(memory);
}

// ---- TLS records read many at a time

SSL* __real_SSL_new(SSL_CTX* context);
int __real_SSL_read(SSL* connection, void* bytes, int size);

// Whatever the socket has, up to a buffer of OpenSSL's, in one system call; without it each record
// takes two.
SSL* __wrap_SSL_new(SSL_CTX* context) {
  SSL* const connection = __real_SSL_new(context);
  if (connection != nullptr) {
    SSL_set_read_ahead(connection, 1);
  }
  return connection;
}

// Paho waits for the socket unless this is above zero. What was read ahead the socket will not
// tell of.
int __wrap_SSL_pending(const SSL* connection) {
  return SSL_has_pending(connection);
}

// For the same reason it must not get less than it asked for while there is more: OpenSSL hands out
// one record at a time.
int __wrap_SSL_read(SSL* connection, void* bytes, int size) {
  int read = 0;
  do {
    const int now = __real_SSL_read(connection, static_cast<char*>(bytes) + read, size - read);
    if (now <= 0) {
      return read > 0 ? read : now;  // an error comes again at the next call
    }
    read += now;
  } while (read < size && SSL_has_pending(connection) == 1);
  return read;
}

}  // extern "C"
// NOLINTEND(cppcoreguidelines-no-malloc)
// NOLINTEND(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)
