#include "bioprint/io/answer.hpp"

#include "io/answer_object.hpp"
#include "io/json_lines.hpp"
#include "io/json_question.hpp"
#include "io/row_answer.hpp"

namespace bioprint {

std::string_view program_version() {
    return BIOPRINT_VERSION;
}

std::string answer_json(const Prediction& prediction, int indent) {
    return json_text(answer_object(prediction), indent);
}

std::string answer_json_line(std::string_view question) {
    return json_text(answer_row([&] { return settings_of(parse_json(question, "the question")); }).object);
}

}  // namespace bioprint
