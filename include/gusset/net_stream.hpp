// Nets as streams of bytes. Include gusset.hpp, not this.
#ifndef GUSSET_NET_STREAM_HPP
#define GUSSET_NET_STREAM_HPP

#include <gusset/net.hpp>

namespace gusset {

/// How coordinates are stored; see the constants.
enum class StreamMode : uint32_t {
    quantised = GUSSET_STREAM_QUANTISED,
    lossless = GUSSET_STREAM_LOSSLESS,
    raw = GUSSET_STREAM_RAW
};

/// How a net is stored; see gusset_stream_options.
struct StreamOptions {
    StreamMode mode = StreamMode::quantised;
    /// Of a coordinate, 8 to 24; 0 for 14. For quantised streams only.
    uint32_t bits = 0;
    /// The step of each axis follows from its own extent. For quantised streams only.
    bool per_axis = false;
    /// 0: the library's choice.
    std::size_t rows_per_block = 0;
};

/// Bytes in somebody else's memory.
using Bytes = Span<const uint8_t>;
/// What the first bytes of a stream say.
using StreamInfo = gusset_stream_report;

/// The bytes of a net; see gusset_net_encode_create. Immutable.
class Stream {
public:
    explicit Stream(const Net &net, const StreamOptions &options = {}, const Context &context = Context()) {
        gusset_stream_options given{};
        given.struct_size = sizeof given;
        given.rows_per_block = options.rows_per_block;
        given.mode = static_cast<gusset_stream_mode>(options.mode);
        given.bits = options.bits;
        given.per_axis = options.per_axis ? 1 : 0;
        gusset_stream *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_net_encode_create(c, net.get(), &given, &created); });
        stream_.reset(created);
    }

    /// Valid as long as this.
    Bytes bytes() const & {
        const void *data = nullptr;
        std::size_t size = 0;
        detail::check(gusset_stream_get_view(stream_.get(), &data, &size));
        return {static_cast<const uint8_t *>(data), size};
    }
    Bytes bytes() const && = delete;

private:
    struct Destroy {
        void operator()(gusset_stream *stream) const noexcept { gusset_stream_destroy(stream); }
    };
    std::unique_ptr<gusset_stream, Destroy> stream_;
};

/// The net of a stream.
inline Net decode(Bytes bytes, const Context &context = Context()) {
    gusset_net *net = nullptr;
    context.call([&](gusset_context *c) { return gusset_net_decode_create(c, bytes.data(), bytes.size(), &net); });
    return Net(net);
}

/// What the first bytes of a stream say; see gusset_stream_inspect.
inline StreamInfo inspect(Bytes bytes, const Context &context = Context()) {
    StreamInfo info{};
    info.struct_size = sizeof info;
    context.call([&](gusset_context *c) { return gusset_stream_inspect(c, bytes.data(), bytes.size(), &info); });
    return info;
}

/// Decodes a stream that arrives in pieces. For one thread at a time.
class Decoder {
public:
    /// Nets of more nodes are refused; 0 for no limit but the library's.
    explicit Decoder(uint64_t node_limit = 0, const Context &context = Context()) {
        gusset_stream_decoder *created = nullptr;
        context.call([&](gusset_context *c) { return gusset_stream_decoder_create(c, node_limit, &created); });
        decoder_.reset(created);
    }

    /// Takes the next bytes, any number of them; returns how many rows are complete.
    std::size_t push(Bytes bytes, const Context &context = Context()) {
        std::size_t rows = 0;
        context.call([&](gusset_context *c) {
            return gusset_stream_decoder_push(c, decoder_.get(), bytes.data(), bytes.size(), &rows);
        });
        return rows;
    }
    /// The rows that are complete, as a net of its own; see gusset_stream_decoder_preview_create.
    Net preview(const Context &context = Context()) const {
        gusset_net *net = nullptr;
        context.call([&](gusset_context *c) { return gusset_stream_decoder_preview_create(c, decoder_.get(), &net); });
        return Net(net);
    }
    /// The whole net; the decoder is empty then.
    Net finish(const Context &context = Context()) {
        gusset_net *net = nullptr;
        context.call([&](gusset_context *c) { return gusset_stream_decoder_finish_create(c, decoder_.get(), &net); });
        return Net(net);
    }

private:
    struct Destroy {
        void operator()(gusset_stream_decoder *decoder) const noexcept { gusset_stream_decoder_destroy(decoder); }
    };
    std::unique_ptr<gusset_stream_decoder, Destroy> decoder_;
};

} // namespace gusset

#endif // GUSSET_NET_STREAM_HPP
