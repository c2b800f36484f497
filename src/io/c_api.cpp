#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "bioprint/bioprint.h"
#include "bioprint/io/answer.hpp"

namespace {

// malloc, because the caller may be no C++ program; bioprint_free is the matching free.
char* duplicate(const std::string& text) {
    auto* copy = static_cast<char*>(std::malloc(text.size() + 1));
    if (copy != nullptr) std::memcpy(copy, text.c_str(), text.size() + 1);
    return copy;
}

std::string failure(const char* code, const char* message) {
    const nlohmann::json answer = {{"schema", "bioprint-predict/1"},
                                   {"error", {{"code", code}, {"message", message}, {"option", nullptr}}}};
    return answer.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

char* bioprint_predict_json(const char* request) {
    // Nothing may be thrown across the C boundary. What the request did wrong is part of the answer already;
    // what still arrives here is a fault of ours or of the machine.
    try {
        if (request == nullptr) return duplicate(failure("usage", "the request is NULL"));
        return duplicate(bioprint::answer_json_line(std::string_view(request)));
    } catch (const std::bad_alloc&) {
        return nullptr;
    } catch (const std::exception& error) {
        try {
            return duplicate(failure("internal", error.what()));
        } catch (...) {
            return nullptr;
        }
    } catch (...) {
        return nullptr;
    }
}

void bioprint_free(char* answer) {
    std::free(answer);
}

const char* bioprint_version() {
    return BIOPRINT_VERSION;
}
