/* SPDX-License-Identifier: MIT */
#ifndef SPEAR_WIRE_H
#define SPEAR_WIRE_H

/* spear_wire: sessions over Cap'n Proto RPC, operations on one machine through shared memory, behind a C interface.
 *
 * The one wire library, used by the SDK (client half) and by the plugin inside the engine (server half). It is built once, with
 * any compiler and standard library; nothing is thrown across, no C++ type crosses, only spear_* symbols are exported. Bytes in
 * `types`, `operations` and `answers` are spear/encode.hpp's; this library does not look into them.
 *
 * Addresses: "unix:/path" (socket mode 0600; a leading '@' in the path means the abstract namespace), "tcp://host:port"
 * (IPv6 in brackets; port 0 lets the system choose, see spear_server_address). */

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define SPEAR_WIRE_API __declspec(dllexport)
#else
#define SPEAR_WIRE_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct spear_bytes {
    const uint8_t* data;
    size_t size;
} spear_bytes;

/* An error as it crosses: code is spear::ErrorCode, the message is cut to fit. */
typedef struct spear_wire_error {
    uint16_t code;
    char message[2048];
} spear_wire_error;

/* Answers with such a request are a call's, the rest of the number is the operation's. */
#define SPEAR_CALL_REQUEST (UINT64_C(1) << 63)
#define SPEAR_CALL_FAILED (UINT64_C(1) << 62)

enum { SPEAR_BLOCK_NONE = 0, SPEAR_BLOCK_BEGIN = 1, SPEAR_BLOCK_END = 2 };
enum { SPEAR_STATE_RUNNING = 0, SPEAR_STATE_HELD_BY_YOU = 1, SPEAR_STATE_HELD_BY_OTHER = 2, SPEAR_STATE_BUSY = 3, SPEAR_STATE_EXITING = 4 };
enum { SPEAR_LEASE_OFF = 0xffffffffu };

/* A batch of operations (protocol/spear.capnp, Batch). */
typedef struct spear_batch {
    uint64_t transaction;
    uint8_t block;
    uint8_t closes;
    uint8_t abort;
    uint8_t single_step;
    spear_bytes types;
    spear_bytes operations;
    const uint64_t* releases;
    size_t release_count;
} spear_batch;

/* The answers to one batch. has_error: the batch as a whole was refused or aborted. */
typedef struct spear_answers {
    spear_bytes types;
    spear_bytes answers;
    uint64_t frame;
    uint8_t has_error;
    uint16_t error_code;
    const char* error_message;
} spear_answers;

/* A synchronous operation outside of any batch: see spear_client_call. */
typedef struct spear_call {
    uint64_t number;      /* of the operation */
    uint16_t entry_point; /* the client's number of it */
    spear_bytes arguments;
} spear_call;

/* Its answer: a value, or an error as in answers. */
typedef struct spear_call_answer {
    uint64_t frame;
    uint8_t failed;
    spear_bytes value;
    spear_bytes types; /* announcements that go ahead of it; from the server only */
} spear_call_answer;

/* Messages one way: batches of operations, or answers to them; bytes of what is in them, without the transport's envelope. */
typedef struct spear_traffic {
    uint64_t messages;
    uint64_t bytes;
} spear_traffic;

typedef struct spear_status {
    uint8_t state;
    uint64_t frame;
    uint32_t frames_age_ms;
    spear_traffic received; /* of this session so far, counted by the server's half of this library: callbacks need not fill them in */
    spear_traffic sent;
    uint64_t kept_results; /* results that the engine keeps for the session's futures */
    char holder[256];
    char detail[512];
} spear_status;

typedef struct spear_description {
    char spear_version[64];
    char engine[128];
    char scene[256];
    uint64_t process_id;
    uint32_t sessions;
    char project[128];
    uint64_t frame;
    uint64_t uptime_ms; /* since the server began to listen; its own affair, not the callback's */
} spear_description;

/* Server half -----------------------------------------------------------------------------------------------------------
 * Callbacks run on the server thread, one at a time, and must not block (`submit`: see there). Pointers in their arguments are valid
 * during the call. */

typedef struct spear_server spear_server;

typedef struct spear_hello {
    uint64_t session;
    const char* client_name;
    uint64_t process_id;
    uint32_t lease_ms; /* as agreed */
    const char* const* entry_points;
    size_t entry_point_count;
} spear_hello;

typedef struct spear_server_callbacks {
    void* user;
    /* A client wants a session; nonzero admits it, zero refuses with the error. Protocol version, token and limits::max_sessions were checked. */
    int (*connect)(void* user, const spear_hello* hello, spear_wire_error* error);
    /* The session is over (closed, connection lost, lease expired: the reason says which). No callback names it any more. */
    void (*disconnect)(void* user, uint64_t session, const char* reason);
    /* A batch arrived; answer exactly once with spear_server_reply(server, session, request, ...), from any thread. The one callback
     * that also runs on other threads (one at a time for each session): on the game thread in spear_server_wait and
     * spear_server_poll, and on the watcher threads of shared memory channels. */
    void (*submit)(void* user, uint64_t session, uint64_t request, const spear_batch* batch);
    void (*status)(void* user, uint64_t session, spear_status* status);
    void (*describe)(void* user, spear_description* description);
    /* Something that somebody who looks for the reason later should find in the engine's log. May be NULL. */
    void (*log)(void* user, const char* text);
} spear_server_callbacks;

typedef struct spear_server_options {
    const char* address;
    const uint8_t* token; /* needed unless the address is a Unix socket or loopback */
    size_t token_size;
    const char* spear_version;
    uint32_t default_lease_ms;
    size_t max_message_bytes;
    size_t max_sessions;
    uint8_t no_channel;             /* offer no shared memory channel, as with SPEAR_CHANNEL=off in the environment */
    const char* registry_directory; /* where running engines are listed (one small JSON file each, removed at stop); NULL: the default directory */
} spear_server_options;

/* Binds, starts the server thread, returns when clients can connect. NULL with the error filled if not. */
SPEAR_WIRE_API spear_server* spear_server_start(const spear_server_options* options, const spear_server_callbacks* callbacks, spear_wire_error* error);
/* The address in a form that clients can use (the real port). Valid until stop. */
SPEAR_WIRE_API const char* spear_server_address(const spear_server* server);
/* Any thread. Copies the bytes. Unknown session or request (it may just have gone): ignored. Replies of one session arrive in call order. */
SPEAR_WIRE_API void spear_server_reply(spear_server* server, uint64_t session, uint64_t request, const spear_answers* answers);
/* Any thread. Ends a session; its disconnect callback follows. */
SPEAR_WIRE_API void spear_server_drop(spear_server* server, uint64_t session, const char* reason);
/* The game thread waits for a session (its open block, its next transaction), at most so long: until a batch of it has been given to
 * `submit`, or spear_server_wake was called since the last wait returned. From its first call until spear_server_release, the game
 * thread itself reads the session's channel. */
SPEAR_WIRE_API void spear_server_wait(spear_server* server, uint64_t session, uint32_t timeout_ms);
/* The same within a block that this session's client holds open, of which nothing is queued: takes calls as well. 1 if `call` was
 * filled; its bytes are a copy, valid until spear_server_answer_call, which must follow. The session number of one that has gone: 0. */
SPEAR_WIRE_API int spear_server_wait_call(spear_server* server, uint64_t session, uint32_t timeout_ms, spear_call* call);
SPEAR_WIRE_API void spear_server_answer_call(spear_server* server, uint64_t session, const spear_call_answer* answer);
/* Game thread: the waiting is over; others read the channel again. A call that is not taken by then ends its session. */
SPEAR_WIRE_API void spear_server_release(spear_server* server);
/* Game thread, at the beginning and at the end of each frame: gives what has arrived in all channels to `submit`. */
SPEAR_WIRE_API void spear_server_poll(spear_server* server);
/* Any thread: ends a spear_server_wait, now or the next. */
SPEAR_WIRE_API void spear_server_wake(spear_server* server);
/* Not from a callback. Ends all sessions, joins the thread, removes the socket. No callback runs afterwards. */
SPEAR_WIRE_API void spear_server_stop(spear_server* server);

/* Client half ------------------------------------------------------------------------------------------------------------ */

typedef struct spear_client spear_client;

typedef struct spear_client_options {
    const char* address;
    const uint8_t* token;
    size_t token_size;
    const char* spear_version;
    const char* client_name;
    uint32_t lease_ms; /* 0: the default; SPEAR_LEASE_OFF */
    uint32_t connect_timeout_ms;
    size_t max_message_bytes;
    const char* const* entry_points;
    size_t entry_point_count;
    uint8_t no_channel; /* use RPC also where shared memory could be had, as with SPEAR_CHANNEL=off in the environment */
    uint8_t no_spin;    /* sleep at once in each wait, on both sides, as with SPEAR_SPIN=off in the environment */
} spear_client_options;

/* Callbacks run on the client's I/O thread, one at a time, and must not block. */
typedef struct spear_client_callbacks {
    void* user;
    /* The answers to the batch submitted under that number, in the order the server gave them. Not with a channel:
     * spear_client_take. */
    void (*answers)(void* user, uint64_t request, const spear_answers* answers);
    /* Once, when the session ends for any reason but spear_client_close. Answers not yet given never come. */
    void (*lost)(void* user, const spear_wire_error* error);
    /* With a channel, about ten times a second: take answers that nobody waits for. May be NULL. */
    void (*attend)(void* user);
} spear_client_callbacks;

/* Connects, starts the I/O thread (which also renews the lease), returns when the session stands. NULL with the error filled if not. */
SPEAR_WIRE_API spear_client* spear_client_connect(const spear_client_options* options, const spear_client_callbacks* callbacks, spear_wire_error* error);
SPEAR_WIRE_API uint64_t spear_client_session(const spear_client* client);
/* Any thread, never blocks; copies the bytes. Batches arrive in call order. `request` is chosen by the caller. Nonzero if the session is over. */
SPEAR_WIRE_API int spear_client_submit(spear_client* client, uint64_t request, const spear_batch* batch);
/* Whether operations and answers travel through shared memory. Constant. */
SPEAR_WIRE_API int spear_client_has_channel(const spear_client* client);
/* With a channel; one thread at a time. The next answers, valid until the next call: 1. None there yet: 0. Not of this protocol: -1,
 * the session is of no use any more. */
SPEAR_WIRE_API int spear_client_take(spear_client* client, uint64_t* request, spear_answers* answers);
/* With a channel; one thread at a time. Waits for something to take, at most so long, or until the number of wakes is not that one. */
SPEAR_WIRE_API void spear_client_wait(spear_client* client, uint32_t wakes, uint32_t timeout_us);
/* With a channel; one thread at a time. A synchronous operation, for which the game thread waits already: in a block that is
 * open, held by an operation that was answered, with no batch of the session unanswered and no call either. Nonzero if it is too large,
 * the game thread does not read yet, or the session is over: then nothing has happened. */
SPEAR_WIRE_API int spear_client_call(spear_client* client, const spear_call* call);
/* The answer to the last call, valid until the next: 1. Not there yet, though it was looked for in a short spin if that pays: 0. With
 * the next that spear_client_take gives, whose request is SPEAR_CALL_REQUEST, perhaps SPEAR_CALL_FAILED, and the operation's number: 2. Not of this protocol: -1. */
SPEAR_WIRE_API int spear_client_take_call(spear_client* client, int spin, spear_call_answer* answer);
/* Any thread. The session's end wakes too. */
SPEAR_WIRE_API uint32_t spear_client_wakes(const spear_client* client);
SPEAR_WIRE_API void spear_client_wake(spear_client* client);
/* Any thread but the I/O thread. Asks the server thread; nonzero with the error filled if no answer within the timeout. */
SPEAR_WIRE_API int spear_client_status(spear_client* client, uint32_t timeout_ms, spear_status* status, spear_wire_error* error);
/* Any thread. What this client has sent and received so far. */
SPEAR_WIRE_API void spear_client_traffic(const spear_client* client, spear_traffic* sent, spear_traffic* received);
/* Not from a callback. Closes the session in good order, joins the thread. No callback runs afterwards. */
SPEAR_WIRE_API void spear_client_close(spear_client* client);

/* Asks the engine at an address what it is, without a session. Nonzero with the error filled if it cannot. */
SPEAR_WIRE_API int spear_describe(const char* address, uint32_t timeout_ms, spear_description* description, spear_wire_error* error);

/* Whether an address is a Unix socket or loopback, where no token is needed; also for what is no address. */
SPEAR_WIRE_API int spear_address_is_local(const char* address);

/* Listing ----------------------------------------------------------------------------------------------------------------- */

/* The directory for this user's sockets and engine list: $XDG_RUNTIME_DIR/spear or /tmp/spear-<uid>, mode 0700, made if absent.
 * Returns its length (0: none can be had safely); the buffer is filled, with a final zero, if it is larger. */
SPEAR_WIRE_API size_t spear_runtime_directory(char* buffer, size_t size);
/* Calls `each` for every engine of this user that is running; NULL: the default directory. Returns their number. */
SPEAR_WIRE_API size_t spear_list_engines(const char* directory, void* user, void (*each)(void* user, const char* address, uint64_t process_id));

/* Removes what killed engines of this user left behind: sockets at which nobody listens, registry entries, shared memory, and, with
 * `logs_too` or a day after their end, logs. Calls `each` (may be NULL) with every path removed; returns their number. launch() and every
 * server that starts do this. NULL: the default directory. */
SPEAR_WIRE_API size_t spear_remove_leftovers(const char* directory, int logs_too, void* user, void (*each)(void* user, const char* path));

#ifdef __cplusplus
}
#endif
#endif
