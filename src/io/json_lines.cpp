#include "io/json_lines.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "bioprint/errors.hpp"
#include "io/text.hpp"

namespace bioprint {

namespace {

using PlainJson = nlohmann::json;

/// Watches a parse and stops it at the first key that comes twice, or at too deep a level.
class Watch {
  public:
    explicit Watch(const std::string& what) : what_(what) {}

    bool operator()(int depth, PlainJson::parse_event_t event, PlainJson& value) {
        if (event == PlainJson::parse_event_t::object_start ||
            event == PlainJson::parse_event_t::array_start) {
            if (depth >= deepest_json) {
                throw UsageError(what_ + ": more than " + std::to_string(deepest_json) + " levels of JSON");
            }
            keys_.emplace_back();
        } else if (event == PlainJson::parse_event_t::object_end ||
                   event == PlainJson::parse_event_t::array_end) {
            keys_.pop_back();
        } else if (event == PlainJson::parse_event_t::key) {
            const auto& key = value.get_ref<const std::string&>();
            if (!keys_.back().insert(key).second)
                throw UsageError(what_ + ": the key " + in_quotes(key) + " comes twice");
        }
        return true;
    }

  private:
    const std::string& what_;
    std::vector<std::set<std::string>> keys_;
};

bool is_blank(std::string_view text) {
    return text.find_first_not_of(" \t\r") == std::string_view::npos;
}

}  // namespace

PlainJson parse_json(std::string_view text, const std::string& what) {
    Watch watch(what);
    try {
        return PlainJson::parse(text.begin(), text.end(), std::ref(watch));
    } catch (const PlainJson::parse_error& error) {
        const std::size_t column = std::min(error.byte, text.size() + 1);
        throw UsageError(what + ": not JSON at byte " + std::to_string(column));
    } catch (const PlainJson::out_of_range&) {
        throw UsageError(what + ": a number that no double-precision number can hold");
    }
}

/// The next line without its end; false at the end of the source.
bool JsonLinesReader::take_line(std::string_view& text, bool& too_long) {
    input_.drop(used_);
    used_ = 0;
    too_long = false;
    std::size_t searched = 0;
    for (;;) {
        const std::string_view rest = input_.rest();
        const std::size_t end = rest.find('\n', searched);
        if (end != std::string_view::npos || (input_.at_end() && !rest.empty())) {
            text = rest.substr(0, end);
            used_ = end == std::string_view::npos ? rest.size() : end + 1;
            too_long = too_long || text.size() > largest_line;
            return true;
        }
        if (input_.at_end()) return too_long;
        searched = rest.size();
        if (rest.size() > largest_line) {
            too_long = true;
            input_.drop(rest.size());
            searched = 0;
        }
        input_.more();
    }
}

bool JsonLinesReader::next() {
    std::string_view text;
    bool too_long = false;
    for (;;) {
        text = {};
        if (!take_line(text, too_long)) return false;
        ++count_;
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (count_ == 1 && text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
        if (too_long || !is_blank(text)) break;
    }
    line_ = JsonLine{.number = count_, .value = nullptr, .error = {}};
    const std::string what = "line " + std::to_string(count_);
    if (too_long) {
        line_.error = what + ": longer than 1 MiB";
        return true;
    }
    try {
        line_.value = parse_json(text, what);
        if (!line_.value.is_object()) {
            line_.value = nullptr;
            line_.error = what + ": not an object; a line is one query such as {\"radius\": 5e-05}";
        }
    } catch (const UsageError& error) {
        line_.error = error.what();
    }
    return true;
}

bool JsonLinesReader::has_buffered_line() const {
    return input_.at_end() || input_.rest().substr(used_).find('\n') != std::string_view::npos;
}

}  // namespace bioprint
