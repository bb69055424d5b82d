/// @file
/// Streams: the compact serialised form of nets. Include gusset.hpp, not this.
#ifndef GUSSET_NET_STREAM_HPP
#define GUSSET_NET_STREAM_HPP

#include <gusset/scene.hpp>
#include <gusset/stream_options.hpp>

namespace gusset {

/// Bytes in memory that belongs to someone else.
using Bytes = Span<const uint8_t>;
/// The header of a stream.
using StreamReport = gusset_stream_report;

/// The bytes of a net or a scene; see gusset_net_encode_create and gusset_scene_encode_create. Immutable.
class Stream {
public:
    /// See ::gusset_net_encode_create.
    explicit Stream(const Net &net, const StreamOptions &options = {}, const Context &context = Context()) {
        const gusset_stream_options given = detail::as_c(options);
        stream_.reset(context.result(gusset_net_encode_create, net.get(), &given));
    }
    /// See ::gusset_scene_encode_create.
    explicit Stream(const Scene &scene, const StreamOptions &options = {}, const Context &context = Context()) {
        const gusset_stream_options given = detail::as_c(options);
        stream_.reset(context.result(gusset_scene_encode_create, scene.get(), &given));
    }

    /// Valid as long as this.
    Bytes bytes() const & {
        const gusset_stream_view found = detail::lent(gusset_stream_get_view, stream_.get());
        return {static_cast<const uint8_t *>(found.data), found.size};
    }
    Bytes bytes() const && = delete;

private:
    detail::Handle<gusset_stream, gusset_stream_destroy> stream_;
};

/// The net of a stream. A net of more nodes than `node_limit` is refused before memory is asked for; 0: 4096 for
/// each byte.
inline Net decode(Bytes bytes, uint64_t node_limit, const Context &context = Context()) {
    return Net(context.result(gusset_net_decode_create, bytes.data(), bytes.size(), node_limit));
}
/// The same with the limit that the size gives.
inline Net decode(Bytes bytes, const Context &context = Context()) { return decode(bytes, 0, context); }

/// The scene of a stream; see gusset_scene_decode_create. All nets together have at most `node_limit` nodes; 0: 4096
/// for each byte.
inline Scene decode_scene(Bytes bytes, uint64_t node_limit = 0, const Context &context = Context()) {
    return Scene(context.result(gusset_scene_decode_create, bytes.data(), bytes.size(), node_limit));
}

/// Reads the header of a stream; see gusset_stream_inspect.
inline StreamReport inspect(Bytes bytes, const Context &context = Context()) {
    return context.result(gusset_stream_inspect, bytes.data(), bytes.size());
}

/// Decodes a stream that arrives in pieces. For one thread at a time.
class StreamDecoder {
public:
    /// Nets of more nodes are refused; 0 for no limit but the library's.
    explicit StreamDecoder(uint64_t node_limit = 0, const Context &context = Context()) {
        decoder_.reset(context.result(gusset_stream_decoder_create, node_limit));
    }

    /// Takes the next bytes, any number of them; returns the number of complete rows.
    std::size_t push(Bytes bytes, const Context &context = Context()) {
        return context.result(gusset_stream_decoder_push, decoder_.get(), bytes.data(), bytes.size());
    }
    /// The complete rows as a net; see gusset_stream_decoder_preview_create.
    Net preview(const Context &context = Context()) const {
        return Net(context.result(gusset_stream_decoder_preview_create, decoder_.get()));
    }
    /// The whole net. Empties the decoder.
    Net finish(const Context &context = Context()) {
        return Net(context.result(gusset_stream_decoder_finish_create, decoder_.get()));
    }

private:
    detail::Handle<gusset_stream_decoder, gusset_stream_decoder_destroy> decoder_;
};

} // namespace gusset

#endif // GUSSET_NET_STREAM_HPP
