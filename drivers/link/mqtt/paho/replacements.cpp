// What takes the place of functions within Debian's Paho C 1.3.12: the linker leads its calls of
// NAME to __wrap_NAME, and __real_NAME to what was called before (--wrap).
#include "gathering.hpp"
#include <openssl/ssl.h>

#include <cstddef>
#include <cstdlib>
#include <thread>

namespace {

// Of Paho's one thread that receives, for all clients of a process.
gsbench::link::Gathering gathering;

}  // namespace

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
// one record at a time. An error is told at once, for with nothing left in the socket nobody would
// ask again: what came before it is part of a packet that will never be whole.
int __wrap_SSL_read(SSL* connection, void* bytes, int size) {
  int read = 0;
  do {
    const int now = __real_SSL_read(connection, static_cast<char*>(bytes) + read, size - read);
    if (now <= 0) {
      const int error = SSL_get_error(connection, now);
      const bool later = error == SSL_ERROR_WANT_READ || error == SSL_ERROR_WANT_WRITE;
      return later && read > 0 ? read : now;
    }
    read += now;
  } while (read < size && SSL_has_pending(connection) == 1);
  return read;
}

// The body of each packet. Of one without a body, Paho does not look whether more is pending.
char* __real_SSLSocket_getdata(SSL* connection, int socket, std::size_t size, std::size_t* read,
                               int* result);
void SSLSocket_addPendingRead(int socket);
char* __wrap_SSLSocket_getdata(SSL* connection, int socket, std::size_t size, std::size_t* read,
                               int* result) {
  gathering.count_message();
  char* const body = __real_SSLSocket_getdata(connection, socket, size, read, result);
  if (size == 0 && SSL_has_pending(connection) == 1) {
    SSLSocket_addPendingRead(socket);
  }
  return body;
}

// ---- messages that come often are received many at a time

// Called where nothing is pending, and without Paho's locks.
int __real_Socket_getReadySocket(int more_work, int timeout_ms, void* mutex, int* result);
int __wrap_Socket_getReadySocket(int more_work, int timeout_ms, void* mutex, int* result) {
  const auto pause = gathering.pause_before_waiting(std::chrono::steady_clock::now());
  if (pause.count() > 0 && timeout_ms > 0) {
    const int ready = __real_Socket_getReadySocket(more_work, 0, mutex, result);
    if (ready > 0 || *result != 0) {
      return ready;  // what is there already does not wait
    }
    std::this_thread::sleep_for(pause);
  }
  return __real_Socket_getReadySocket(more_work, timeout_ms, mutex, result);
}

}  // extern "C"
// NOLINTEND(cppcoreguidelines-no-malloc)
// NOLINTEND(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)
