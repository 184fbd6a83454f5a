// print_documents COUNT: random documents, as the program writes them, in one JSON list on standard output; each of
// them can be read. For the test of the JSON Schema.

#include <iostream>
#include <string>

#include "core/document/native_file.h"
#include "tests/core/document/random_document.h"

int main(int argument_count, char** arguments) {
    using namespace batten::core;
    const int count = argument_count > 1 ? std::stoi(arguments[1]) : 1;
    constexpr unsigned seed = 12;
    RandomCurves random(seed);
    for (int i = 0; i < count; ++i) {
        const std::string text = format_document(random_rich_document(random));
        if (const auto read = parse_document(text); !read) {
            std::cerr << read.error().sentence() << '\n' << text;
            return 1;
        }
        std::cout << (i == 0 ? "[" : ",") << text;
    }
    std::cout << "]\n";
    return 0;
}
