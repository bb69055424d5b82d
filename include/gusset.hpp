/// @file
/// gusset: joins surfaces that come in pieces. The C++17 face of gusset.h: RAII, ranges, exceptions.
/// Header only.
///
/// * Every failure is a gusset::Error with the status, the sentence and the report, also if the wrapper detects it.
/// * A callback may throw: the call is cancelled, and the exception comes out of it.
/// * Results own their memory. Spans and views of a result are valid as long as it lives. The pointer of an empty
/// span is null. Results are immutable and may be read from many threads. A Context serves one
///   call at a time.
#ifndef GUSSET_HPP
#define GUSSET_HPP

#include <gusset/alignment.hpp>
#include <gusset/attributes.hpp>
#include <gusset/boundary.hpp>
#include <gusset/certificate.hpp>
#include <gusset/check.hpp>
#include <gusset/curve.hpp>
#include <gusset/development.hpp>
#include <gusset/facing.hpp>
#include <gusset/fill.hpp>
#include <gusset/frame.hpp>
#include <gusset/join.hpp>
#include <gusset/net.hpp>
#include <gusset/net_analysis.hpp>
#include <gusset/net_mesh.hpp>
#include <gusset/net_stream.hpp>
#include <gusset/net_topology.hpp>
#include <gusset/net_validation.hpp>
#include <gusset/outline.hpp>
#include <gusset/repair.hpp>
#include <gusset/scene.hpp>
#include <gusset/section.hpp>
#include <gusset/sheet.hpp>
#include <gusset/sheet_mesh.hpp>
#include <gusset/stitch.hpp>
#include <gusset/strip.hpp>
#include <gusset/surface.hpp>
#include <gusset/trim.hpp>
#include <gusset/winged.hpp>

#endif // GUSSET_HPP
