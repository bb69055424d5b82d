/// @file
/// The options of gusset/mesh.h. Where a comment says NULL, an empty list or options without changes are meant.
/// Generated from src/capi; do not edit. Include gusset.hpp, not this.
#ifndef GUSSET_MESH_OPTIONS_HPP
#define GUSSET_MESH_OPTIONS_HPP

#include <gusset/span.hpp>

namespace gusset {

/// Options of gusset_weld and gusset_sew. See ::gusset_weld_options.
struct WeldOptions {
    /// Vertices that are welded.
    WeldVertices vertices = WeldVertices::boundary;
    /// Distance at which vertices coincide.
    /// - GUSSET_TOLERANCE_EXACT: 0; -0 equals 0.
    /// - GUSSET_TOLERANCE_AUTO: at most 2^-19 (32-bit) or 2^-48 (64-bit) of the largest coordinate, or, if more, twice
    ///   the last decimal place that positions show. At each vertex at most a quarter of the shortest edge;
    ///   GUSSET_COLLAPSE_ALLOW skips edges within the first limit.
    /// - Last decimal place: let D be the largest power of ten up to the longest side of the vertices' box. The place
    ///   is the largest of 1e-5 D, 1e-6 D, ... that divides a third of at least eight numbers. They are coordinates of
    ///   the largest order of magnitude, or differences of consecutive vertices, except multiples of 1e-4 D.
    ToleranceMode tolerance_mode = ToleranceMode::automatic;
    /// Largest distance of coincident vertices. A value sets tolerance_mode to GUSSET_TOLERANCE_GIVEN.
    std::optional<double> tolerance;
    /// Treatment of coincident corners of one face.
    Collapse collapse = Collapse::never;
    /// Treatment of vertices that no face uses.
    Unused unused = Unused::keep;
};

/// Options of gusset_stitch. See ::gusset_stitch_options.
struct StitchOptions {
    /// Rule for the meridians.
    Meridians meridians = Meridians::continuation;
    /// Treatment of opposite orientations.
    Orientation orientation = Orientation::fix;
    /// Vertices to shift the first meridian along rim B, in the direction of rim A, modulo rim B. The shift begins at
    /// the closest pair that no edge joins. If not 0, no other start is tried. 0 for arcs (OUT_OF_RANGE).
    int64_t twist = 0;
    /// Part of the loops to join.
    StitchExtent extent = StitchExtent::whole_loops;
    /// Choice among runs of facing vertices.
    FacingRun run = FacingRun::closest;
    /// Number of interior rows.
    RowRule rows = RowRule::none;
    /// Interior rows. A value sets rows to GUSSET_ROWS_COUNT.
    std::optional<uint32_t> row_count;
    /// Faces of the strip.
    StripCells cells = StripCells::triangles;
    /// Source of the tolerance.
    ToleranceMode tolerance_mode = ToleranceMode::automatic;
    /// Facing vertices are farther than this from their loop's plane. A value sets tolerance_mode to
    /// GUSSET_TOLERANCE_GIVEN.
    std::optional<double> tolerance;
    /// First index on loop A as given, and number of vertices, 1 to the loop's length; may pass its end. A value sets
    /// extent to GUSSET_EXTENT_ARCS.
    std::optional<std::array<uint32_t, 2>> arc_a;
    /// As arc_a, for loop B. A value sets extent to GUSSET_EXTENT_ARCS.
    std::optional<std::array<uint32_t, 2>> arc_b;
    /// Search effort.
    StripSearch search = StripSearch::automatic;
    /// First meridian of a closed strip; open ones start at their first points.
    StripStart start = StripStart::automatic;
    /// Positions of new vertices; ignored without rows.
    Fairing fairing = Fairing::none;
    /// Treatment of intersecting faces.
    Intersections intersections = Intersections::automatic;
    /// Centre of a loop.
    Centres centres = Centres::vertices;
    /// Side that closed components face.
    Outward outward = Outward::automatic;
    /// Surface between the rims, or in a hole.
    Finish finish = Finish::strip;
};

/// Options of gusset_fill. See ::gusset_fill_options.
struct FillOptions {
    /// Weight that the triangulation of a hole minimises.
    FillWeight weight = FillWeight::continuation;
    /// New vertices of patches.
    FillRefinement refine = FillRefinement::none;
    /// Positions of new vertices; ignored without them.
    Fairing fairing = Fairing::none;
    /// Loops that are not holes, if all loops are selected.
    FillKeep keep = FillKeep::automatic;
    /// Patch faces that intersect each other or old faces: AUTO avoids, REPORT reports, IGNORE ignores them.
    Intersections intersections = Intersections::automatic;
    /// 1: only reports which loops would be filled, by which weight and finish, without predicting failed
    /// triangulations and shared patches.
    bool plan_only = false;
    /// Approximate limit on a patch's new vertices, kept by larger triangles, within a factor of 2. 0: 50,000, or 4 a
    /// rim vertex if more; twice that for sharp angles.
    uint32_t max_new_vertices = 0;
    /// Most edges of a loop to fill; 0: any.
    uint32_t max_edges = 0;
    /// Largest length of a loop to fill, at least 0; 0: any.
    double max_length = 0.0;
    /// As max_length, for diameter of gusset_hole.
    double max_diameter = 0.0;
    /// As max_length, for area of gusset_hole.
    double max_area = 0.0;
    /// Side that closed components face.
    Outward outward = Outward::automatic;
    /// Loops that share a patch.
    FillTogether together = FillTogether::apart;
    /// Group of each given loop; the group's loops share a patch of genus 0, except loops left open for their own
    /// reasons. NULL: together decides.
    std::vector<uint32_t> groups;
    /// Smoothness between faired patches and the old surface.
    FillContinuity continuity = FillContinuity::c1;
    /// 1: creases of the old surface end at the rim.
    bool ignore_creases = false;
    /// Surface between the rims, or in a hole.
    Finish finish = Finish::strip;
};

/// Options of gusset_trim_create. See ::gusset_trim_options.
struct TrimOptions {
    /// Largest distance of surfaces that count as one. 0: 4 mean edges of the coarser piece.
    double max_distance = 0.0;
    /// Largest angle between their normals, at least 0, below pi / 2; 0: 60 degrees.
    double max_angle = 0.0;
    /// A point for each piece, or NULL. Parts seen at flat angles weigh less.
    std::vector<Point3> viewpoints;
    /// Islands of fewer faces are removed; 0: 30. The limit is 20 times that for islands that other pieces also show.
    /// Smaller holes are not made.
    uint32_t min_faces = 0;
};

/// Options of gusset_join. See ::gusset_join_options.
struct JoinOptions {
    /// Treatment of coincident borders.
    Welding weld = Welding::sew;
    /// GUSSET_ORIENTATION_FIX reverses the minority of faces in each component, then components against those that they
    /// face. GUSSET_ORIENTATION_KEEP ignores outward and reverses nothing. Takes GUSSET_ORIENTATION_FIX,
    /// GUSSET_ORIENTATION_KEEP only.
    Orientation orientation = Orientation::fix;
    /// Parts of loops that are joined.
    JoinExtent extent = JoinExtent::loops_and_parts;
    /// 1 also joins loops of one component that pairs does not name.
    bool within_components = false;
    /// 1 fills the remaining holes.
    bool fill = false;
    /// Widest gap to close; 0 closes none. A value sets gap of C to GUSSET_GAP_GIVEN; empty: GUSSET_GAP_AUTO.
    std::optional<double> max_gap;
    /// Pairs of whole loops to join at any distance, or NULL: two loops, or a slit twice (see gusset_joint). No loop is
    /// in two pairs.
    std::vector<gusset_loop_pair> pairs;
    /// Pairs not to join, or NULL; pairs takes precedence. Vertices on no loop after welding exclude nothing.
    std::vector<gusset_loop_pair> excluded;
    /// Options of welding.
    WeldOptions weld_options;
    /// Uses meridians, search, start, rows, row_count, cells, fairing, intersections and finish; all options must be
    /// valid.
    StitchOptions strip_options;
    /// Ignores groups, and outward and plan_only, which must be valid. With GUSSET_OVERLAPS_TRIM, GUSSET_KEEP_AUTO acts
    /// as GUSSET_KEEP_BORDERS.
    FillOptions fill_options;
    /// Open components mostly keep the first piece's orientation.
    Outward outward = Outward::automatic;
    /// Treatment of overlapping pieces.
    Overlaps overlaps = Overlaps::keep;
    /// Options of trimming. Read only if overlaps is GUSSET_OVERLAPS_TRIM.
    TrimOptions trim_options;
};

/// Options of gusset_strip. See ::gusset_strip_options.
struct StripOptions {
    /// Rule for the meridians.
    Meridians meridians = Meridians::continuation;
    /// Search effort.
    StripSearch search = StripSearch::automatic;
    /// First meridian of a closed strip; open ones start at their first points.
    StripStart start = StripStart::automatic;
    /// 1 if the polylines are closed.
    bool closed = false;
    /// Number of interior rows.
    RowRule rows = RowRule::none;
    /// Interior rows. A value sets rows to GUSSET_ROWS_COUNT.
    std::optional<uint32_t> row_count;
    /// Faces of the strip.
    StripCells cells = StripCells::triangles;
};

/// Options of gusset_orient. See ::gusset_orient_options.
struct OrientOptions {
    /// Side that closed components face.
    Outward outward = Outward::automatic;
};

/// Options of gusset_repair. See ::gusset_repair_options.
struct RepairOptions {
    /// Source of the tolerance.
    ToleranceMode tolerance_mode = ToleranceMode::automatic;
    /// 1: borders are not sewn.
    bool leave_borders = false;
    /// Largest distance of coincident borders. A value sets tolerance_mode to GUSSET_TOLERANCE_GIVEN.
    std::optional<double> tolerance;
    /// 1: faces without area stay.
    bool leave_flat_faces = false;
    /// 1: duplicate faces stay.
    bool leave_duplicates = false;
    /// 1: non-manifold edges and vertices stay, and faces within the solid.
    bool leave_non_manifold = false;
    /// 1: holes stay open.
    bool leave_holes = false;
    /// 1: open sheets that were attached to closed components stay.
    bool leave_fins = false;
    /// 1: no component is oriented.
    bool leave_orientation = false;
    /// 1: intersecting faces stay.
    bool leave_intersections = false;
    /// Ignores groups, and outward and plan_only, which must be valid.
    FillOptions fill_options;
};

/// Options of gusset_alignment_create. See ::gusset_alignment_options.
struct AlignmentOptions {
    /// Initial poses.
    AlignmentStart start = AlignmentStart::as_given;
    /// Points of a piece to match; 0: 2,000.
    uint32_t samples = 0;
    /// Rigid motions of the pieces, or NULL. Read only if start is GUSSET_ALIGN_AS_GIVEN.
    std::vector<gusset_transform> poses;
    /// Largest distance of matched points, and about how far a piece may move. 0: a tenth of the largest piece's box
    /// diagonal.
    double max_distance = 0.0;
    /// Most rounds in each of two stages; 0: 100.
    uint32_t max_rounds = 0;
};

/// Options of gusset_boundary_create. See ::gusset_boundary_options.
struct BoundaryOptions {
    /// Treatment of non-manifold edges.
    NonManifold non_manifold = NonManifold::cut;
    /// Part of the mesh that is checked.
    Survey survey = Survey::whole_mesh;
};

/// Options of gusset_develop. See ::gusset_develop_options.
struct DevelopOptions {
    /// Distortion that a development minimises.
    Distortion distortion = Distortion::symmetric;
    /// Most darts: cuts from a chart's border to where it is curved.
    uint32_t max_darts = 0;
    /// Vertices of paths to cut along, path after path, connected by shortest edge paths. A path of one vertex cuts
    /// nothing.
    std::vector<uint32_t> cuts;
    /// Start of each path in cuts, and the end of the last. Empty: one path.
    std::vector<uint32_t> cut_offsets;
    /// Darts stop once no length changes by a larger factor; above 1, finite; 0: none.
    double max_stretch = 0.0;
    /// Most steps of a descent; 0: 200. Charts whose border would meet itself, and GUSSET_DISTORTION_RIGID, need
    /// several descents.
    uint32_t max_iterations = 0;
};

/// Options of gusset_facing_create. See ::gusset_facing_options.
struct FacingOptions {
    /// Choice among runs of facing vertices.
    FacingRun run = FacingRun::closest;
    /// Source of the tolerance.
    ToleranceMode tolerance_mode = ToleranceMode::automatic;
    /// As in gusset_stitch_options. A value sets tolerance_mode to GUSSET_TOLERANCE_GIVEN.
    std::optional<double> tolerance;
    /// Centre of a loop.
    Centres centres = Centres::vertices;
};

/// Options of gusset_mesh_sections_create. See ::gusset_mesh_section_options.
struct MeshSectionOptions {
    /// Leaves out points up to this far from the polyline; 0: keeps all points. Polylines with points left out may
    /// cross each other or themselves.
    double tolerance = 0.0;
    /// Side of vertices in a plane.
    InPlane in_plane = InPlane::above;
};

namespace detail {
inline gusset_weld_options as_c(const WeldOptions &options) {
    auto given = sized<gusset_weld_options>();
    given.vertices = static_cast<gusset_weld_vertices>(options.vertices);
    given.tolerance_mode = static_cast<gusset_tolerance_mode>(options.tolerance_mode);
    given.collapse = static_cast<gusset_collapse>(options.collapse);
    given.unused = static_cast<gusset_unused>(options.unused);
    if (options.tolerance) {
        given.tolerance = *options.tolerance;
        given.tolerance_mode = GUSSET_TOLERANCE_GIVEN;
    }
    return given;
}

inline gusset_stitch_options as_c(const StitchOptions &options) {
    auto given = sized<gusset_stitch_options>();
    given.meridians = static_cast<gusset_meridians>(options.meridians);
    given.orientation = static_cast<gusset_orientation>(options.orientation);
    given.twist = options.twist;
    given.extent = static_cast<gusset_stitch_extent>(options.extent);
    given.run = static_cast<gusset_facing_run>(options.run);
    given.rows = static_cast<gusset_row_rule>(options.rows);
    given.cells = static_cast<gusset_strip_cells>(options.cells);
    given.tolerance_mode = static_cast<gusset_tolerance_mode>(options.tolerance_mode);
    given.search = static_cast<gusset_strip_search>(options.search);
    given.start = static_cast<gusset_strip_start>(options.start);
    given.fairing = static_cast<gusset_fairing>(options.fairing);
    given.intersections = static_cast<gusset_intersections>(options.intersections);
    given.centres = static_cast<gusset_centres>(options.centres);
    given.outward = static_cast<gusset_outward>(options.outward);
    given.finish = static_cast<gusset_finish>(options.finish);
    if (options.row_count) {
        given.row_count = *options.row_count;
        given.rows = GUSSET_ROWS_COUNT;
    }
    if (options.tolerance) {
        given.tolerance = *options.tolerance;
        given.tolerance_mode = GUSSET_TOLERANCE_GIVEN;
    }
    if (options.arc_a) {
        std::copy(options.arc_a->begin(), options.arc_a->end(), given.arc_a);
        given.extent = GUSSET_EXTENT_ARCS;
    }
    if (options.arc_b) {
        std::copy(options.arc_b->begin(), options.arc_b->end(), given.arc_b);
        given.extent = GUSSET_EXTENT_ARCS;
    }
    return given;
}

inline gusset_fill_options as_c(const FillOptions &options) {
    auto given = sized<gusset_fill_options>();
    given.weight = static_cast<gusset_fill_weight>(options.weight);
    given.refine = static_cast<gusset_fill_refinement>(options.refine);
    given.fairing = static_cast<gusset_fairing>(options.fairing);
    given.keep = static_cast<gusset_fill_keep>(options.keep);
    given.intersections = static_cast<gusset_intersections>(options.intersections);
    given.plan_only = options.plan_only ? 1 : 0;
    given.max_new_vertices = options.max_new_vertices;
    given.max_edges = options.max_edges;
    given.max_length = options.max_length;
    given.max_diameter = options.max_diameter;
    given.max_area = options.max_area;
    given.outward = static_cast<gusset_outward>(options.outward);
    given.together = static_cast<gusset_fill_together>(options.together);
    given.groups = first(options.groups);
    given.continuity = static_cast<gusset_fill_continuity>(options.continuity);
    given.ignore_creases = options.ignore_creases ? 1 : 0;
    given.finish = static_cast<gusset_finish>(options.finish);
    return given;
}
gusset_fill_options as_c(const FillOptions &&) = delete;

inline gusset_trim_options as_c(const TrimOptions &options) {
    auto given = sized<gusset_trim_options>();
    given.max_distance = options.max_distance;
    given.max_angle = options.max_angle;
    given.viewpoints = numbers(first(options.viewpoints));
    given.viewpoint_count = options.viewpoints.size();
    given.min_faces = options.min_faces;
    return given;
}
gusset_trim_options as_c(const TrimOptions &&) = delete;

/// The options that gusset_join_options points to.
struct JoinOptionsNested {
    gusset_weld_options weld_options;
    gusset_stitch_options strip_options;
    gusset_fill_options fill_options;
    gusset_trim_options trim_options;
};
inline gusset_join_options as_c(const JoinOptions &options, JoinOptionsNested &nested) {
    auto given = sized<gusset_join_options>();
    given.weld = static_cast<gusset_welding>(options.weld);
    given.orientation = static_cast<gusset_orientation>(options.orientation);
    given.extent = static_cast<gusset_join_extent>(options.extent);
    given.within_components = options.within_components ? 1 : 0;
    given.fill = options.fill ? 1 : 0;
    given.pairs = first(options.pairs);
    given.pair_count = options.pairs.size();
    given.excluded = first(options.excluded);
    given.excluded_count = options.excluded.size();
    nested.weld_options = as_c(options.weld_options);
    given.weld_options = &nested.weld_options;
    nested.strip_options = as_c(options.strip_options);
    given.strip_options = &nested.strip_options;
    nested.fill_options = as_c(options.fill_options);
    given.fill_options = &nested.fill_options;
    given.outward = static_cast<gusset_outward>(options.outward);
    given.overlaps = static_cast<gusset_overlaps>(options.overlaps);
    nested.trim_options = as_c(options.trim_options);
    given.trim_options = &nested.trim_options;
    if (options.max_gap) {
        given.max_gap = *options.max_gap;
        given.gap = GUSSET_GAP_GIVEN;
    }
    return given;
}
gusset_join_options as_c(const JoinOptions &&, JoinOptionsNested &) = delete;

inline gusset_strip_options as_c(const StripOptions &options) {
    auto given = sized<gusset_strip_options>();
    given.meridians = static_cast<gusset_meridians>(options.meridians);
    given.search = static_cast<gusset_strip_search>(options.search);
    given.start = static_cast<gusset_strip_start>(options.start);
    given.closed = options.closed ? 1 : 0;
    given.rows = static_cast<gusset_row_rule>(options.rows);
    given.cells = static_cast<gusset_strip_cells>(options.cells);
    if (options.row_count) {
        given.row_count = *options.row_count;
        given.rows = GUSSET_ROWS_COUNT;
    }
    return given;
}

inline gusset_orient_options as_c(const OrientOptions &options) {
    auto given = sized<gusset_orient_options>();
    given.outward = static_cast<gusset_outward>(options.outward);
    return given;
}

/// The options that gusset_repair_options points to.
struct RepairOptionsNested {
    gusset_fill_options fill_options;
};
inline gusset_repair_options as_c(const RepairOptions &options, RepairOptionsNested &nested) {
    auto given = sized<gusset_repair_options>();
    given.tolerance_mode = static_cast<gusset_tolerance_mode>(options.tolerance_mode);
    given.leave_borders = options.leave_borders ? 1 : 0;
    given.leave_flat_faces = options.leave_flat_faces ? 1 : 0;
    given.leave_duplicates = options.leave_duplicates ? 1 : 0;
    given.leave_non_manifold = options.leave_non_manifold ? 1 : 0;
    given.leave_holes = options.leave_holes ? 1 : 0;
    given.leave_fins = options.leave_fins ? 1 : 0;
    given.leave_orientation = options.leave_orientation ? 1 : 0;
    given.leave_intersections = options.leave_intersections ? 1 : 0;
    nested.fill_options = as_c(options.fill_options);
    given.fill_options = &nested.fill_options;
    if (options.tolerance) {
        given.tolerance = *options.tolerance;
        given.tolerance_mode = GUSSET_TOLERANCE_GIVEN;
    }
    return given;
}
gusset_repair_options as_c(const RepairOptions &&, RepairOptionsNested &) = delete;

inline gusset_alignment_options as_c(const AlignmentOptions &options) {
    auto given = sized<gusset_alignment_options>();
    given.start = static_cast<gusset_alignment_start>(options.start);
    given.samples = options.samples;
    given.poses = first(options.poses);
    given.pose_count = options.poses.size();
    given.max_distance = options.max_distance;
    given.max_rounds = options.max_rounds;
    return given;
}
gusset_alignment_options as_c(const AlignmentOptions &&) = delete;

inline gusset_boundary_options as_c(const BoundaryOptions &options) {
    auto given = sized<gusset_boundary_options>();
    given.non_manifold = static_cast<gusset_non_manifold>(options.non_manifold);
    given.survey = static_cast<gusset_survey>(options.survey);
    return given;
}

inline gusset_develop_options as_c(const DevelopOptions &options) {
    auto given = sized<gusset_develop_options>();
    given.distortion = static_cast<gusset_distortion>(options.distortion);
    given.max_darts = options.max_darts;
    given.cuts = {first(options.cuts), options.cuts.size()};
    given.cut_offsets = {first(options.cut_offsets), options.cut_offsets.size()};
    given.max_stretch = options.max_stretch;
    given.max_iterations = options.max_iterations;
    return given;
}
gusset_develop_options as_c(const DevelopOptions &&) = delete;

inline gusset_facing_options as_c(const FacingOptions &options) {
    auto given = sized<gusset_facing_options>();
    given.run = static_cast<gusset_facing_run>(options.run);
    given.tolerance_mode = static_cast<gusset_tolerance_mode>(options.tolerance_mode);
    given.centres = static_cast<gusset_centres>(options.centres);
    if (options.tolerance) {
        given.tolerance = *options.tolerance;
        given.tolerance_mode = GUSSET_TOLERANCE_GIVEN;
    }
    return given;
}

inline gusset_mesh_section_options as_c(const MeshSectionOptions &options) {
    auto given = sized<gusset_mesh_section_options>();
    given.tolerance = options.tolerance;
    given.in_plane = static_cast<gusset_in_plane>(options.in_plane);
    return given;
}
} // namespace detail

} // namespace gusset

#endif // GUSSET_MESH_OPTIONS_HPP
