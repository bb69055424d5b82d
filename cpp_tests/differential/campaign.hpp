// Campaigns of random cases: random numbers, failures, and families.
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace campaign {

/// Random numbers that are equal on every platform. The standard library's engines are portable, its distributions
/// are not.
class Random {
public:
    explicit Random(uint64_t seed) : engine_(seed) {}
    /// From 0 to below `count`.
    uint32_t below(std::size_t count) { return static_cast<uint32_t>(engine_() % count); }
    bool one_in(std::size_t count) { return below(count) == 0; }
    /// From `low` to `high`, both included.
    uint32_t between(uint32_t low, uint32_t high) { return low + below(high - low + std::size_t{1}); }
    double unit() { return static_cast<double>(engine_() >> 11) / 9007199254740992.0; }
    double real(double low, double high) { return low + (high - low) * unit(); }
    template <class T>
    const T &any(const std::vector<T> &list) { return list[below(list.size())]; }
    template <class T>
    void shuffle(std::vector<T> &list) {
        for (std::size_t k = list.size(); k > 1; --k) {
            std::swap(list[k - 1], list[below(k)]);
        }
    }

private:
    std::mt19937_64 engine_;
};

/// One case: its randomness, its checks, and a sentence for each that failed.
class Case {
public:
    explicit Case(uint64_t seed) : random(seed) {}

    bool check(bool holds, const char *sentence) {
        ++checks;
        if (!holds) {
            failed.emplace_back(sentence);
        }
        return holds;
    }
    /// `what`: a noun; the sentence has both values.
    template <class A, class B>
    bool equal(const A &ours, const B &theirs, const char *what) {
        ++checks;
        if (ours == static_cast<A>(theirs)) {
            return true;
        }
        std::ostringstream text;
        text << what << ": " << ours << ", and " << theirs << " by the other way";
        failed.push_back(text.str());
        return false;
    }
    /// `value` <= `limit`; not so if one is NaN.
    bool at_most(double value, double limit, const char *what) {
        ++checks;
        if (value <= limit) {
            return true;
        }
        std::ostringstream text;
        text.precision(17);
        text << what << ": " << value << " is more than " << limit;
        failed.push_back(text.str());
        return false;
    }
    /// Counts in how many cases something was so, for the reader of the table.
    void note(const std::string &what) { ++notes[what]; }

    Random random;
    std::size_t checks = 0;
    std::vector<std::string> failed;
    std::map<std::string, std::size_t> notes;
};

struct Family {
    const char *name;
    void (*run)(Case &);
    /// Cases that are run if no number is given, which take less than a second.
    std::size_t few;
};

void loops(Case &);
void validity(Case &);
void intersections(Case &);
void surfaces(Case &);
void curves(Case &);
void gluings(Case &);
void overlaps(Case &);
void sections(Case &);
void real_sections(Case &);

} // namespace campaign
