#include "drive.h"

#include "../choices.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace viewer {
namespace {
/// So many frames after a change, the picture that is being rendered is the one of the changed state: the layout takes
/// one, the request another.
int const frames_until_settled = 3;

using Command = std::function<void(std::istream&, Session&)>;
using Commands = std::map<std::string, Command>;

template <class Value>
Value const& find(std::string const& name, std::map<std::string, Value> const& choices)
{
    auto const found = choices.find(name);
    if (found == choices.end())
        throw std::invalid_argument("there is no '" + name + "' here");
    return found->second;
}

template <class Enum>
Enum read_choice(std::istream& arguments, std::map<std::string, Enum> const& choices)
{
    std::string name;
    arguments >> name;
    return find(name, choices);
}

bool read_choice_of_two(std::istream& arguments, char const* no, char const* yes)
{
    return read_choice(arguments, std::map<std::string, bool>{{no, false}, {yes, true}});
}

void read_size(std::istream& arguments, State& state)
{
    std::string first;
    arguments >> first;
    state.size_is_fixed = first != "window";
    if (!state.size_is_fixed)
        return;
    state.params.width = std::stoi(first);
    arguments >> state.params.height;
}

void drag(std::istream& arguments, State& state)
{
    CameraInput input;
    arguments >> input.left_drag.x >> input.left_drag.y;
    state.view = state.flies ? fly(state.view, input) : orbit(state.view, input);
}

Commands make_commands()
{
    Commands commands = {
        {"scene", [](auto& in, Session& s) { in >> s.state.scene; }},
        {"filter", [](auto& in, Session& s) { s.state.params.tex_filter_mode = read_choice(in, filter_choices()); }},
        {"wrap", [](auto& in, Session& s) { s.state.params.tex_wrap_mode = read_choice(in, wrap_choices()); }},
        {"mode", [](auto& in, Session& s) { s.state.params.render_mode = read_choice(in, mode_choices()); }},
        {"depth", [](auto& in, Session& s) { in >> s.state.params.max_depth; }},
        {"spp", [](auto& in, Session& s) { in >> s.state.params.spp; }},
        {"epsilon", [](auto& in, Session& s) { in >> s.state.params.ray_epsilon; }},
        {"fov", [](auto& in, Session& s) { in >> s.state.params.fovy; }},
        {"exposure", [](auto& in, Session& s) { in >> s.state.exposure.stops; }},
        {"gamma", [](auto& in, Session& s) { in >> s.state.exposure.gamma; }},
        {"size", [](auto& in, Session& s) { read_size(in, s.state); }},
        {"panel", [](auto& in, Session& s) { s.state.shows_panel = read_choice_of_two(in, "off", "on"); }},
        {"camera", [](auto& in, Session& s) { s.state.flies = read_choice_of_two(in, "orbit", "fly"); }},
        {"reset", [](auto&, Session& s) { s.reset_view(); }},
        {"drag", [](auto& in, Session& s) { drag(in, s.state); }},
        {"save",
         [](auto& in, Session& s) {
             std::string file;
             in >> file;
             s.save(file);
         }},
    };
    for (Switch const& entry : switches())
        commands[entry.name] = [entry](std::istream& in, Session& s) {
            s.state.params.*entry.value = read_choice_of_two(in, "off", "on");
        };
    return commands;
}

void obey(std::string const& name, std::istream& arguments, Session& session)
{
    static Commands const commands = make_commands();
    find(name, commands)(arguments, session);
    if (arguments.fail())
        throw std::invalid_argument("arguments are missing");
}
}  // namespace

Drive::Drive(std::string const& file) : file_(file)
{
    std::ifstream in(file);
    if (!in)
        throw std::runtime_error("cannot read " + file);
    for (std::string line; std::getline(in, line);)
        lines_.push_back(line);
}

bool Drive::must_wait(Session const& session)
{
    if (++frames_waited_ > frames_until_settled && session.progress().finished) {
        frames_waited_ = 0;
        return false;
    }
    return true;
}

Drive::Wishes Drive::step(Session& session)
{
    Wishes wishes;
    if (next_ >= lines_.size())
        return wishes;
    std::istringstream line(lines_[next_]);
    std::string word;
    line >> word;
    if (word == "wait" && must_wait(session))
        return wishes;
    ++next_;
    if (word == "quit")
        wishes.quit = true;
    else if (word == "screenshot")
        line >> wishes.screenshot;
    else if (!word.empty() && word != "wait")
        try {
            obey(word, line, session);
        } catch (std::exception const& error) {
            throw std::runtime_error(file_ + ", line " + std::to_string(next_) + ": " + error.what());
        }
    return wishes;
}

}  // namespace viewer
