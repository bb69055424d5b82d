/* Scans: pieces that overlap, moved to where they fit, trimmed, and joined. */
#include "example.h"

#define SIDE 24

/* A piece of a height field, as triangles. */
typedef struct piece {
    double points[SIDE * SIDE][3];
    uint32_t corners[(SIDE - 1) * (SIDE - 1)][6];
} piece;

/* The part of it from x = first on, as a scanner saw it that was turned about the z axis and moved along the x axis. */
static gusset_mesh_view scan(piece *made, double first, double turn, double shift) {
    uint32_t i, j;

    for (i = 0; i < SIDE; ++i) {
        for (j = 0; j < SIDE; ++j) {
            const double x = first + 0.65 * j / (SIDE - 1), y = 1.0 * i / (SIDE - 1);
            double *p = made->points[SIDE * i + j];
            p[0] = cos(turn) * x - sin(turn) * y + shift, p[1] = sin(turn) * x + cos(turn) * y;
            p[2] = 0.1 * sin(7.0 * x) + 0.1 * cos(7.0 * y) + 0.05 * x * y;
        }
    }
    for (i = 0; i < SIDE - 1; ++i) {
        for (j = 0; j < SIDE - 1; ++j) {
            const uint32_t v = SIDE * i + j;
            const uint32_t two[6] = {v, v + 1, v + SIDE + 1, v, v + SIDE + 1, v + SIDE};
            memcpy(made->corners[(SIDE - 1) * i + j], two, sizeof two);
        }
    }
    return gusset_triangles_f64(made->points[0], SIDE * SIDE, made->corners[0], sizeof made->corners / sizeof(uint32_t[3]));
}

/* Takes the points of a piece to their new places. */
static void move(piece *moved, const gusset_transform *pose) {
    size_t v, k;

    for (v = 0; v < SIDE * SIDE; ++v) {
        const double *row = pose->rows, p[3] = {moved->points[v][0], moved->points[v][1], moved->points[v][2]};
        for (k = 0; k < 3; ++k, row += 4) {
            moved->points[v][k] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
        }
    }
}

//! [align]
static void where_pieces_belong(void) {
    piece first, second, truth;
    gusset_mesh_view pieces[2];
    gusset_alignment_view found = {.struct_size = sizeof found};
    gusset_alignment *alignment = NULL;
    size_t v, k;

    /* The second piece is turned by 2 degrees, and moved. */
    pieces[0] = scan(&first, 0.0, 0.0, 0.0);
    pieces[1] = scan(&second, 0.35, pi / 90.0, 0.02);
    MUST(gusset_alignment_create(NULL, pieces, 2, NULL, &alignment));
    MUST(gusset_alignment_get_view(alignment, &found));
    HOLDS(found.piece_count == 2 && found.converged == 1);
    HOLDS(found.pieces[0].reason == GUSSET_ALIGNED_TRUSTED && found.pieces[1].reason == GUSSET_ALIGNED_TRUSTED);
    HOLDS(found.overlap_count == 1 && found.overlaps[0].trusted == 1 && found.overlaps[0].shares[0] > 0.3);

    /* Its pose takes it to where it belongs. */
    move(&second, &found.pieces[1].pose);
    scan(&truth, 0.35, 0.0, 0.0);
    for (v = 0; v < SIDE * SIDE; ++v) {
        for (k = 0; k < 3; ++k) {
            HOLDS(fabs(second.points[v][k] - truth.points[v][k]) < 1e-2);
        }
    }
    gusset_alignment_destroy(alignment);
}
//! [align]

//! [apart]
static void pieces_that_are_far_apart(void) {
    piece first, second;
    gusset_mesh_view pieces[2];
    /* No motion, and one by -9 along the x axis. */
    const gusset_transform poses[2] = {{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}}, {{1, 0, 0, -9, 0, 1, 0, 0, 0, 0, 1, 0}}};
    const gusset_alignment_options from_there = {.struct_size = sizeof from_there, .poses = poses, .pose_count = 2};
    gusset_alignment_view found = {.struct_size = sizeof found};
    gusset_alignment *alignment = NULL;

    pieces[0] = scan(&first, 0.0, 0.0, 0.0);
    pieces[1] = scan(&second, 0.35, 0.0, 9.0);
    MUST(gusset_alignment_create(NULL, pieces, 2, NULL, &alignment));
    MUST(gusset_alignment_get_view(alignment, &found));
    /* This is not an error: the second piece stays, and is not trusted. */
    HOLDS(found.pieces[1].reason == GUSSET_ALIGNED_NO_OVERLAP && found.overlap_count == 0);
    HOLDS(about(found.pieces[1].pose.rows[0], 1.0) && about(found.pieces[1].pose.rows[3], 0.0));
    gusset_alignment_destroy(alignment);

    /* With a better start, its pose is found. */
    MUST(gusset_alignment_create(NULL, pieces, 2, &from_there, &alignment));
    MUST(gusset_alignment_get_view(alignment, &found));
    HOLDS(found.pieces[1].reason == GUSSET_ALIGNED_TRUSTED && fabs(found.pieces[1].pose.rows[3] + 9.0) < 1e-2);
    gusset_alignment_destroy(alignment);
}
//! [apart]

//! [trim]
static void what_is_kept_of_an_overlap(void) {
    piece first, second;
    gusset_mesh_view pieces[2];
    gusset_trim_view left = {.struct_size = sizeof left};
    gusset_trim *trim = NULL;
    size_t k, f;

    pieces[0] = scan(&first, 0.0, 0.0, 0.0);
    pieces[1] = scan(&second, 0.35, 0.0, 0.0);
    MUST(gusset_trim_create(NULL, pieces, 2, NULL, &trim));
    MUST(gusset_trim_get_view(trim, &left));
    HOLDS(left.piece_count == 2 && left.pieces[0].covered_vertices > 0 && left.pieces[1].covered_vertices > 0);
    HOLDS(left.pieces[0].kept.count + left.pieces[1].kept.count < pieces[0].face_count + pieces[1].face_count);
    for (k = 0; k < 2; ++k) {
        const gusset_indices kept = left.pieces[k].kept;
        for (f = 1; f < kept.count; ++f) {
            HOLDS(kept.data[f - 1] < kept.data[f] && kept.data[f] < pieces[k].face_count);
        }
    }
    gusset_trim_destroy(trim);
}
//! [trim]

//! [join]
static void scans_made_one_mesh(void) {
    piece first, second;
    gusset_mesh_view pieces[2];
    const gusset_join_options trimmed = {.struct_size = sizeof trimmed, .overlaps = GUSSET_OVERLAPS_TRIM};
    gusset_alignment_view found = {.struct_size = sizeof found};
    gusset_join_report parts = {.struct_size = sizeof parts};
    gusset_alignment *alignment = NULL;
    gusset_result *joined = NULL;

    pieces[0] = scan(&first, 0.0, 0.0, 0.0);
    pieces[1] = scan(&second, 0.35, pi / 90.0, 0.02);
    MUST(gusset_alignment_create(NULL, pieces, 2, NULL, &alignment));
    MUST(gusset_alignment_get_view(alignment, &found));
    HOLDS(found.pieces[1].reason == GUSSET_ALIGNED_TRUSTED);
    move(&second, &found.pieces[1].pose);
    gusset_alignment_destroy(alignment);

    MUST(gusset_join(NULL, pieces, 2, &trimmed, &joined));
    MUST(gusset_result_get_join(joined, &parts));
    /* A strip between the two, and the border round both. */
    HOLDS(parts.trimmed_faces > 0 && parts.joint_count > 0 && parts.joints[0].outcome == GUSSET_JOINT_JOINED);
    HOLDS(parts.loops_left == 1 && parts.non_manifold_edges == 0);
    gusset_result_destroy(joined);
}
//! [join]

int main(void) {
    where_pieces_belong();
    pieces_that_are_far_apart();
    what_is_kept_of_an_overlap();
    scans_made_one_mesh();
    return 0;
}
