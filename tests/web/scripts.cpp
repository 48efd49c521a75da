#include <iostream>
#include <sstream>
#include <string>

#include "app/host/host.hpp"
#include "app/host/lesson/address.hpp"
#include "app/web/page.hpp"
#include "lessons/files/catalogue.hpp"

/// The interface driven by a script, as a page is driven by its browser: events in, states out. Each line of
/// the input is an event; each line of the output is the address and the state after a frame.
namespace {

using jw::host::InputEvent;

void carry_out(const std::string& line, jw::host::Host& host) {
    std::istringstream words(line);
    std::string what;
    words >> what;
    if (what == "go") {
        std::string address;
        words >> address;
        host.go_to(jw::host::read_address(address));
    } else if (what == "key") {
        std::string name;
        bool down = false;
        words >> name >> down;
        host.push(InputEvent::pressed(jw::web::key_of(name == "Space" ? " " : name), down));
    } else if (what == "text") {
        unsigned character = 0;
        words >> character;
        host.push(InputEvent::typed(character));
    } else if (what == "pointer") {
        float x = 0.0F;
        float y = 0.0F;
        words >> x >> y;
        host.push(InputEvent::pointer(x, y));
    } else if (what == "button") {
        int number = 0;
        bool down = false;
        words >> number >> down;
        host.push(InputEvent::button(number, down));
    } else if (what == "wheel") {
        float notches = 0.0F;
        words >> notches;
        host.push(InputEvent::wheel(notches));
    } else if (what == "frame") {
        double seconds = 0.0;
        words >> seconds;
        host.frame(seconds);
        std::cout << fragment_of(host.address()) << '\t' << state_text(host) << '\n';
    } else {
        throw std::runtime_error("no event '" + line + "'");
    }
}

}  // namespace

int main() {
    try {
        jw::host::HostSetup setup;
        setup.catalogue = jw::catalogue_folder();
        jw::host::Host host(setup);
        for (std::string line; std::getline(std::cin, line);) { carry_out(line, host); }
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
