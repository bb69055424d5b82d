// Blocks and messages on disk. DIY's own storage detects neither an unwritable folder, nor a full disk.
#pragma once

#include "soup.hpp"

#include <vtkdiy2/storage.hpp>

#include <map>
#include <unistd.h>

namespace tiles {
/// Files of one rank. All throw std::runtime_error with the name of the file.
class Storage : public diy::ExternalStorage {
public:
    explicit Storage(const std::string &folder) : name_((std::filesystem::path(folder) / "block.XXXXXX").string()) {}
    Storage(const Storage &) = delete;
    Storage &operator=(const Storage &) = delete;
    ~Storage() {
        while (!files_.empty()) {
            destroy(files_.begin()->first);
        }
    }

    int put(diy::MemoryBuffer &bytes) override {
        const int number = write([&](diy::BinaryBuffer &to) { to.save_binary(bytes.buffer.data(), bytes.buffer.size()); });
        bytes.wipe();
        return number;
    }
    int put(const void *block, diy::detail::Save save) override {
        return write([&](diy::BinaryBuffer &to) { save(block, to); });
    }
    void get(int number, diy::MemoryBuffer &bytes, std::size_t extra) override {
        const std::size_t size = files_.at(number).bytes;
        bytes.buffer.reserve(size + extra);
        bytes.buffer.resize(size);
        read(number, [&](diy::BinaryBuffer &from) { from.load_binary(bytes.buffer.data(), size); });
    }
    void get(int number, void *block, diy::detail::Load load) override {
        read(number, [&](diy::BinaryBuffer &from) { load(block, from); });
    }
    void destroy(int number) override {
        std::remove(files_.at(number).name.c_str());
        bytes_ -= files_.at(number).bytes;
        files_.erase(number);
    }

    /// The largest total size of all files.
    std::size_t max_bytes() const { return max_bytes_; }

private:
    struct Kept {
        std::string name;
        std::size_t bytes;
    };

    template <class Function>
    int write(Function &&function) {
        std::string name = name_;
        const int descriptor = mkstemp(name.data());
        if (descriptor < 0) {
            throw std::runtime_error("cannot write " + name);
        }
        // Known from here on, so that it goes whatever happens.
        const auto at = files_.emplace(next_, Kept{name, 0}).first;
        File file(fdopen(descriptor, "wb"));
        if (!file) {
            close(descriptor);
            throw std::runtime_error("cannot write " + name);
        }
        diy::detail::FileBuffer to(file.get());
        function(to);
        const bool good = std::ferror(file.get()) == 0;
        if (std::fclose(file.release()) != 0 || !good) {
            throw std::runtime_error("cannot write " + name + ": is the disk full?");
        }
        at->second.bytes = to.size();
        bytes_ += to.size();
        max_bytes_ = std::max(max_bytes_, bytes_);
        return next_++;
    }
    template <class Function>
    void read(int number, Function &&function) {
        const Kept &kept = files_.at(number);
        std::error_code none;
        const File file(std::fopen(kept.name.c_str(), "rb"));
        if (!file || std::filesystem::file_size(kept.name, none) != kept.bytes) {
            throw std::runtime_error("cannot read " + kept.name + ", or it is cut short");
        }
        diy::detail::FileBuffer from(file.get());
        function(from);
        if (std::ferror(file.get()) != 0) {
            throw std::runtime_error("cannot read " + kept.name);
        }
        destroy(number);
    }

    std::string name_;
    std::map<int, Kept> files_;
    std::size_t bytes_ = 0, max_bytes_ = 0;
    int next_ = 0;
};
} // namespace tiles
