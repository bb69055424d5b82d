// Draws the figures of the four papers into a folder, each by the library's functions, and prints their numbers:
// figures FOLDER The same bytes each time.
#include "figure.hpp"

#include <iostream>

int main(int argc, char **argv) {
    if (argc != 2) {
        std::cerr << "usage: figures FOLDER\n";
        return 2;
    }
    using namespace figures;
    try {
        for (const auto &paper : {nesterenko(), deryagin(), leus(), nadopta()}) {
            for (const Entry &figure : paper) {
                const std::string numbers = figure.draw(std::string(argv[1]) + "/" + figure.name + ".svg");
                std::cout << figure.name << ": " << numbers << std::endl;
            }
        }
        return 0;
    } catch (const gusset::Error &error) {
        std::cerr << error.what() << " (status " << error.status() << ")\n";
    } catch (const std::exception &error) {
        std::cerr << error.what() << '\n';
    }
    return 1;
}
