// SPDX-License-Identifier: MIT
// Opens a door from C++; open_door.py beside it does the same and prints the same. Both need an engine with the Door
// plugin:
//
//     tools/spear engine --address unix:/tmp/door.sock --plugin-dir build/release/example_plugins
//     build/release/bin/open_door unix:/tmp/door.sock

#include <cstdio>
#include <exception>

#include <spear/spear.hpp>

namespace {

void open_door(const char* address) {
    spear::Instance instance = spear::connect(address);
    auto frame = instance.begin_frame();
    spear::Object door = instance.game().spawn_actor("ADoor", {.location = {100, 0, 0}});
    std::printf("at most %.1f degrees\n", door["MaxAngle"].get<double>());
    door.call("Open");
    std::printf("Open(): %.1f\n", door.call<double>("GetAngle"));
    door.call("Open", spear::arg("Angle", 45));
    std::printf("Open(45): %.1f\n", door.call<double>("GetAngle"));
    door["MaxAngle"].set(60.0);
    door.call("Open", spear::arg("Angle", 80));
    std::printf("Open(80) with MaxAngle 60: %.1f\n", door.call<double>("GetAngle"));
    instance.game().destroy_actor(door);
    frame.execute();
    instance.end_frame().execute();
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: open_door ADDRESS\nOpens a door in the engine at unix:/path or tcp://host:port; it needs "
                   "the Door plugin.\n",
            stderr);
        return 2;
    }
    try {
        open_door(arguments[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "open_door: %s\n", error.what());
        return 1;
    }
    return 0;
}
