# SPDX-License-Identifier: MIT
@0xac6d1325aa7c439b;
# Sessions, frames and the envelope of operations. What is inside `types`, `operations` and `answers` is the value encoding of
# spear/encode.hpp: code inside Unreal Engine cannot include Cap'n Proto's headers, and one encoding serves every transport.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("spear::protocol");

const protocolVersion :UInt32 = 1;

interface Gateway {
  # What a connection starts with.

  connect @0 (hello :Hello) -> (welcome :Welcome, session :Session);
  # Fails the call (never the connection) if versions, token or entry points differ: Welcome.error then says how.

  describe @1 () -> (description :Description);
  # Without a session: for listing engines.
}

struct Hello {
  protocolVersion @0 :UInt32;
  spearVersion @1 :Text;
  clientName @2 :Text;          # for people: program name and process id; other clients see it in HeldByClient
  processId @3 :UInt64;
  token @4 :Data;               # needed for addresses other than a Unix socket or loopback
  leaseMs @5 :UInt32;           # 0: the default; 0xffffffff: no lease (native debuggers)
  entryPoints @6 :List(Text);   # signatures, in the order of their numbers
}

struct Welcome {
  error @0 :Error;              # unset: welcome
  sessionId @1 :UInt64;
  leaseMs @2 :UInt32;
  spearVersion @3 :Text;
  protocolVersion @4 :UInt32;
}

struct Error {
  code @0 :UInt16;              # spear::ErrorCode
  message @1 :Text;
}

struct Description {
  spearVersion @0 :Text;
  engine @1 :Text;
  scene @2 :Text;
  processId @3 :UInt64;
  sessions @4 :UInt32;
  project @5 :Text;
  frame @6 :UInt64;
  uptimeMs @7 :UInt64;          # since the server began to listen
}

interface Session {
  submit @0 (batch :Batch) -> (answers :Answers);
  # Returns when the batch has run on the game thread (server-thread operations: at once).

  renew @1 () -> ();
  # Renews the lease; any other call does too.

  status @2 () -> (status :Status);
  # Answered by the server thread, always at once: why a wait takes so long.

  close @3 () -> ();
  # Ends the session in good order. Dropping the connection does the same.

  offerChannel @4 () -> (name :Text);
  # Before the first submit: makes a region of shared memory (docs/protocol.md, "The channel"). Empty: there is none to be had.

  openChannel @5 (nonce :Data, spin :Bool) -> (opened :Bool);
  # The nonce that the client has read in the region. The right one proves that both see the same memory; then submit is over
  # and batches and answers travel there. Any other answer takes the offer back.

  ended @6 () -> ();
  # Fails when the session ends, with the reason: how a client that submits nothing here hears of it. Never returns.
}

enum Block {
  none @0;                      # outside of blocks: server-thread and any-frame operations
  begin @1;
  end @2;
}

struct Batch {
  transaction @0 :UInt64;       # counted up by the client, never 0 within a block
  block @1 :Block;
  closes @2 :Bool;              # the last batch of the block; an all-asynchronous block is one batch that closes
  abort @3 :Bool;               # with closes: run what was recorded, then close the whole transaction with an empty end block
  singleStep @4 :Bool;          # with the closing batch of an end block
  types @5 :Data;               # announcements made since the last batch
  operations @6 :Data;
  releases @7 :List(UInt64);    # futures (operation numbers) whose kept results the server may drop
}

struct Answers {
  types @0 :Data;
  answers @1 :Data;
  frame @2 :UInt64;             # the engine's frame in which the batch ran
  error @3 :Error;              # set if the batch as a whole was refused or aborted
}

struct Status {
  state @0 :State;
  frame @1 :UInt64;
  holder @2 :Text;              # who holds the engine, if somebody does
  framesAgeMs @3 :UInt32;       # since the last frame began
  detail @4 :Text;
  batchesReceived @5 :UInt64;   # of this session so far, as the server counts them
  bytesReceived @6 :UInt64;     # of their types, operations and releases
  answersSent @7 :UInt64;
  bytesSent @8 :UInt64;         # of their types and answers
  keptResults @9 :UInt64;       # results that the engine keeps for this session's futures

  enum State {
    running @0;
    heldByYou @1;               # the caller's own block or single_step
    heldByOther @2;
    busy @3;                    # no frames: loading, modal dialog
    exiting @4;
  }
}
