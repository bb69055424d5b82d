// Peak memory of all other operations on ordinary inputs, as docs/guides/guarantees.md states it.
#include "row.hpp"
#include "shapes.hpp"

namespace complexity {

namespace {
using gusset::Context;
using gusset::Curve;
using gusset::Net;
using gusset::Sheet;
using gusset::Surface;

Net net_of_grid(const Grid &grid) { return Net::from_points(grid.rows, grid.columns, grid.points); }
Grid rough(std::size_t n, uint32_t seed = 1) { return random_grid(n, seed, 0.8); }

template <class Function>
Row on_net(const char *name, double bytes, Function function, const char *family = "net") {
    return {name, family, 4096, 0, 1, 1, bytes, [=](std::size_t n) {
                const auto net = std::make_shared<Net>(net_of_grid(rough(n)));
                return making([=](const Context &context) { return function(*net, context); });
            }, true};
}

/// Operations that change a net, or compute a number of it.
template <class Function>
Row with_net(const char *name, double bytes, Function function, const char *family = "net") {
    return on_net(name, bytes, [=](Net &net, const Context &context) {
        function(net, context);
        return 0;
    }, family);
}

template <class Function>
Row on_curve(const char *name, double bytes, Function function) {
    return {name, "circle", 1024, 0, 1, 1, bytes, [=](std::size_t n) {
                const auto curve = std::make_shared<const Curve>(curve_of(circle(3 * n + 1, 1.0, 0.0), 3));
                return making([=](const Context &context) { return function(*curve, context); });
            }, true};
}

template <class Function>
Row on_sheet(const char *name, double bytes, Function function, const char *family = "sheet") {
    return {name, family, 1024, 0, 1, 1, bytes, [=](std::size_t n) {
                const auto sheet = std::make_shared<const Sheet>(sheet_of(rough(n)));
                return making([=](const Context &context) { return function(*sheet, context); });
            }, true};
}

template <class Function>
Row on_surface(const char *name, std::size_t size, double work, double bytes, Function function,
               const char *family = "surface") {
    return {name, family, size, 0, work, 1, bytes, [=](std::size_t n) {
                const auto sheet = std::make_shared<const Sheet>(sheet_of(rough(n)));
                const auto surface = std::make_shared<const Surface>(*sheet);
                return making([=](const Context &context) { return function(*surface, context); });
            }, true};
}

void add_net_rows(std::vector<Row> &rows) {
    rows.push_back({"net_create", "nodes", 4096, 0, 1, 1, 0, [](std::size_t n) {
                        const auto grid = std::make_shared<const Grid>(rough(n));
                        return making([=](const Context &context) {
                            return Net::from_points(grid->rows, grid->columns, grid->points, {}, context);
                        });
                    }, true});
    rows.push_back({"net_from_heights_create", "heights", 4096, 0, 1, 1, 0, [](std::size_t n) {
                        const auto grid = std::make_shared<const Grid>(plane_grid(n));
                        const auto heights = std::make_shared<std::vector<double>>(grid->rows * grid->columns, 0.5);
                        return making([=](const Context &context) {
                            return Net::from_heights(grid->rows, grid->columns, heights->data(), {}, context);
                        });
                    }, true});
    rows.push_back({"net_from_mesh_create", "quads", 4096, 0, 1, 1, 0, [](std::size_t n) {
                        const auto mesh = std::make_shared<const gusset::NetMesh>(net_of_grid(plane_grid(n)));
                        return making([=](const Context &context) { return gusset::NetGrid(mesh->mesh(), gusset::NetGridOptions(), context); });
                    }, true});
    rows.push_back({"net_from_mesh_create", "triangles", 4096, 0, 1, 1, 0, [](std::size_t n) {
                        gusset::NetMeshOptions options;
                        options.faces = gusset::NetFaces::triangles_fixed;
                        const auto mesh = std::make_shared<const gusset::NetMesh>(net_of_grid(plane_grid(n)), options);
                        gusset::NetGridOptions pairs;
                        pairs.cells = gusset::GridCells::triangles;
                        return making([=](const Context &context) { return gusset::NetGrid(mesh->mesh(), pairs, context); });
                    }, true});
    rows.push_back(on_net("net_copy_create", 0, [](const Net &net, const Context &) { return Net(net); }));
    rows.push_back(on_net("net_copy_create", 0, [](const Net &net, const Context &context) {
        return net.converted(gusset::Scalar::f32, context);
    }, "floats"));
    rows.push_back(on_net("net_copy_create", 0, [](const Net &net, const Context &context) {
        return net.part(0, net.rows(), 0, net.columns(), context);
    }, "part"));
    rows.push_back(on_net("net_copy_create", 0, [](const Net &net, const Context &context) { return net.transposed(context); }, "transposed"));
    rows.push_back(on_net("net_copy_create", 0, [](const Net &net, const Context &context) {
        return net.flipped(gusset::Direction::right, context);
    }, "flipped"));
    rows.push_back(on_net("net_copy_create", 0, [](const Net &net, const Context &context) { return net.turned(1, context); }, "turned"));
    rows.push_back(on_net("net_copy_create", 0, [](const Net &net, const Context &context) {
        gusset::NetCopyOptions options;
        options.rows = net.rows() + 1;
        options.columns = net.columns() + 1;
        return net.copied(options, context);
    }, "larger"));
    rows.push_back(on_net("net_copy_create", 0, [](const Net &net, const Context &context) { return net.compacted(context); }, "compact"));
    rows.push_back(on_net("net_decimate_create", 0, [](const Net &net, const Context &context) { return net.decimated(0.1, context); }));
    rows.push_back(on_net("net_pyramid_create", 0, [](const Net &net, const Context &context) {
        return net.pyramid(gusset::Interpolation::bicubic, context);
    }));
    rows.push_back(on_net("net_morph_create", 0, [](const Net &net, const Context &context) {
        return net.morphed(net, 0.5, gusset::MorphPath::rigid, context);
    }));
    rows.push_back(on_net("net_concatenate_create", 0, [](const Net &net, const Context &context) {
        return concatenate(net, net, {}, context);
    }));
    rows.push_back(on_net("net_split_create", 0, [](const Net &net, const Context &context) {
        return concatenate(net, net, {}, context).split(0, context);
    }));
    rows.push_back(on_net("net_analysis_create", 0, [](const Net &net, const Context &context) {
        return gusset::NetAnalysis(net, net, context);
    }));
    rows.push_back(on_net("net_complex_create", 0, [](const Net &net, const Context &context) {
        return gusset::NetComplex(net, gusset::NetCells::all, context);
    }));
    rows.push_back(on_net("net_groups_create", 0, [](const Net &net, const Context &context) { return gusset::NetGroups(net, context); }));
    rows.push_back(with_net("net_glue", 0, [](Net &net, const Context &context) { net.saturate(context); }, "saturated"));
    rows.push_back(with_net("net_histogram", 0, [](Net &net, const Context &context) { (void)net.histogram(context); }));
    rows.push_back(with_net("net_measure", 0, [](Net &net, const Context &context) {
        (void)net.measure(gusset::NetMeasures::extent, context);
    }));
    rows.push_back(with_net("net_measure", 0, [](Net &net, const Context &context) {
        (void)net.measure(gusset::NetMeasures::bilinear | gusset::NetMeasures::body, context);
    }, "patches, body"));
    rows.push_back(with_net("net_transform", 0, [](Net &net, const Context &context) {
        net.transform(gusset::Operation::translate({1, 2, 3}), context);
    }));
    rows.push_back(with_net("net_deform", 0, [](Net &net, const Context &context) {
        net.deform(gusset::Field::spherify({0, 0, 0}, 1.0), 1.0, context);
    }));
    rows.push_back(with_net("net_displace", 0, [](Net &net, const Context &context) { net.displace(0.1, context); }));
    rows.push_back(with_net("net_planarise", 0, [](Net &net, const Context &context) {
        gusset::PlanariseOptions options;
        options.max_iterations = 3;
        (void)net.planarise(options, context);
    }));
}

/// Bridges that settle, scenes, and streams that arrive in pieces.
void add_joined_rows(std::vector<Row> &rows) {
    const auto bridged = [](const Net &net, std::size_t n) {
        gusset::ConcatenateOptions options;
        options.rows = static_cast<uint32_t>(n / net.columns());
        options.properties.tension = 1;
        return concatenate(net, net, options);
    };
    rows.push_back({"net_settle", "bridge", 4096, 0, 1, 1, 0, [=](std::size_t n) {
                        const auto net = std::make_shared<Net>(bridged(net_of_grid(plane_grid(n)), n));
                        return making([=](const Context &context) {
                            gusset::SettleOptions options;
                            options.max_iterations = 3;
                            return net->settle(options, context).iterations;
                        });
                    }, true});
    rows.push_back(on_net("scene_unflatten_create", 0, [](const Net &net, const Context &context) {
        return gusset::Scene::unflatten(net, gusset::Direction::down, context);
    }));
    rows.push_back({"stream_decoder_push", "pieces", 4096, 0, 1, 1, 0, [](std::size_t n) {
                        const auto stream = std::make_shared<const gusset::Stream>(net_of_grid(rough(n)));
                        return making([=](const Context &context) {
                            gusset::StreamDecoder decoder(0, context);
                            const auto bytes = stream->bytes();
                            for (std::size_t at = 0; at < bytes.size(); at += 1000) {
                                decoder.push({bytes.data() + at, std::min<std::size_t>(1000, bytes.size() - at)}, context);
                            }
                            return decoder.finish(context);
                        });
                    }, true});
}

void add_curve_rows(std::vector<Row> &rows) {
    rows.push_back({"curve_through_create", "circle", 1024, 0, 1, 1, 0, [](std::size_t n) {
                        const auto points = std::make_shared<const std::vector<Point3>>(circle(n, 1.0, 0.0));
                        return making([=](const Context &context) {
                            return Curve::through(*points, true, gusset::Scheme::six_tap, context);
                        });
                    }, true});
    rows.push_back(on_curve("curve_sample_create", 0, [](const Curve &curve, const Context &context) {
        return curve.sample(gusset::SampleRule::count, 1000.0, context);
    }));
    rows.push_back(on_curve("curve_part_create", 0, [](const Curve &curve, const Context &context) {
        return curve.part({0, 0, 0.5}, {static_cast<uint32_t>(curve.segment_count() - 1), 0, 0.5}, context);
    }));
    rows.push_back(on_curve("curve_reverse_create", 0, [](const Curve &curve, const Context &context) { return curve.reversed(context); }));
    rows.push_back(on_curve("curve_change_degree_create", 0, [](const Curve &curve, const Context &context) {
        return curve.with_degrees(4, 64, 0.0, context);
    }));
    rows.push_back(on_curve("curve_change_degree_create", 0, [](const Curve &curve, const Context &context) {
        return curve.with_degrees(1, 2, 1e-3, context);
    }));
    for (const gusset::CurveFormat format : {gusset::CurveFormat::svg, gusset::CurveFormat::contour, gusset::CurveFormat::spline}) {
        rows.push_back(on_curve("curve_export_create", 0, [format](const Curve &curve, const Context &context) {
            return curve.exported(format, 1e-3, context);
        }));
    }
    rows.push_back(on_curve("curve_tangent_angle_create", 0, [](const Curve &curve, const Context &context) {
        return curve.tangents_at_angle({1, 0, 0}, 0.3, context);
    }));
    rows.push_back(on_curve("curve_lengths_at", 0, [](const Curve &curve, const Context &context) {
        const gusset::Place at[] = {{0, 0, 0.5}};
        return curve.lengths_at(at, context);
    }));
    rows.push_back(on_curve("curve_places_at", 0, [](const Curve &curve, const Context &context) {
        const double at[] = {0.5};
        return curve.places_at(at, context);
    }));
    rows.push_back({"outlines_find_sections", "circle", 1024, 0, 1, 1, 0, [](std::size_t n) {
                        const auto points = std::make_shared<const std::vector<Point3>>(circle(n, 1.0, 0.0));
                        return making([=](const Context &context) {
                            return gusset::Sections(gusset::Outlines(*points, true), gusset::OutlineOptions(), context);
                        });
                    }, true});
    const auto two_rims = [](auto function) {
        return [=](std::size_t n) {
            const auto a = std::make_shared<const std::vector<Point3>>(circle(n, 1.0, 0.0));
            const auto b = std::make_shared<const std::vector<Point3>>(circle(n, 1.1, 0.3));
            return making([=](const Context &context) { return function(*a, *b, context); });
        };
    };
    using Points = std::vector<Point3>;
    rows.push_back({"strip", "circles", 1024, 0, 1, 1, 0, two_rims([](const Points &a, const Points &b, const Context &context) {
                        gusset::StripOptions options;
                        options.closed = true;
                        return gusset::Strip(a, b, options, context);
                    }), true});
}

void add_surface_rows(std::vector<Row> &rows) {
    rows.push_back({"sheet_create", "nodes", 1024, 0, 1, 1, 0, [](std::size_t n) {
                        const auto grid = std::make_shared<const Grid>(rough(n));
                        return making([=](const Context &context) {
                            return Sheet::from_nodes(gusset::NodesView(grid->rows, grid->columns, grid->points), context);
                        });
                    }, true});
    rows.push_back({"sheet_from_frame_create", "circles", 1024, 0, 1, 1, 0, [](std::size_t n) {
                        std::vector<Point3> points;
                        std::vector<uint32_t> offsets{0};
                        for (std::size_t k = 0; k < 8; ++k) {
                            const auto section = circle(n / 8, 1.0, static_cast<double>(k));
                            points.insert(points.end(), section.begin(), section.end());
                            offsets.push_back(static_cast<uint32_t>(points.size()));
                        }
                        gusset::Outlines sections(points, true);
                        sections.offsets(offsets);
                        const auto frame = std::make_shared<const gusset::Frame>(sections);
                        return making([=](const Context &context) {
                            return Sheet::from_frame(*frame, gusset::FrameSurface::nodes, context);
                        });
                    }, true});
    rows.push_back({"sheet_from_curves_create", "circles", 256, 0, 1, 1, 0, [](std::size_t n) {
                        const auto curves = std::make_shared<std::vector<Curve>>();
                        for (std::size_t k = 0; k < 8; ++k) {
                            curves->push_back(curve_of(circle(3 * (n / 8) + 1, 1.0, static_cast<double>(k)), 3));
                        }
                        return making([=](const Context &context) {
                            return Sheet::from_curves(*curves, {}, {}, context);
                        });
                    }, true});
    rows.push_back(on_sheet("sheet_measure", 0, [](const Sheet &sheet, const Context &context) { return sheet.estimates(context); }, "estimates"));
    rows.push_back(on_sheet("sheet_measure", 0, [](const Sheet &sheet, const Context &context) { return sheet.diameters(context); }, "diameters"));
    rows.push_back(on_sheet("sheet_measure", 0, [](const Sheet &sheet, const Context &context) { return sheet.crease(context); }, "crease"));
    rows.push_back(on_sheet("sheet_measure", 0, [](const Sheet &sheet, const Context &context) { return sheet.curvature_bound(context); }, "curvature"));
    rows.push_back(on_sheet("sheet_curve_create", 0, [](const Sheet &sheet, const Context &context) {
        return sheet.curve(gusset::SheetDirection::rows, 1.5, context);
    }));
    rows.push_back(on_sheet("sheet_reference_mask", 0, [](const Sheet &sheet, const Context &context) {
        return sheet.reference_mask(gusset::ReferenceTask::at({0, 0, 5}), context);
    }));
    const auto line = gusset::Line::line({0, 0.3, 2}, {1, 0.2, 0});
    rows.push_back(on_surface("surface_region_create", 1024, 1, 0, [](const Surface &surface, const Context &context) {
        return surface.region({0, 0, 0}, 1e9, context);
    }));
    rows.push_back(on_surface("surface_distance", 256, 1, 0, [=](const Surface &surface, const Context &context) {
        return surface.distance(line, 0.0, context);
    }, "line"));
    rows.push_back(on_surface("surface_first_hits", 256, 1, 0, [=](const Surface &surface, const Context &context) {
        return surface.first_hits({&line, 1}, context);
    }));
    rows.push_back(on_surface("surface_nearest_angle", 256, 1, 0, [](const Surface &surface, const Context &context) {
        return surface.nearest_angle({0, 0, 1}, 0.3, gusset::NormalSide::one, context);
    }));
    rows.push_back(on_surface("surface_contours_create", 256, 1, 0, [](const Surface &surface, const Context &context) {
        const auto sheet = surface.sheets()[0];
        std::vector<double> values((sheet.rows + 1) * (sheet.columns + 1));
        for (std::size_t k = 0; k < values.size(); ++k) {
            values[k] = static_cast<double>(k % (sheet.columns + 1));
        }
        const double level[] = {1.5};
        return surface.contours(values, level, {}, context);
    }, "values"));
    rows.push_back(on_surface("surface_cell_pairs_create", 256, 1, 0, [](const Surface &surface, const Context &context) {
        return surface.cell_pairs(surface, 0.0, context);
    }));
    rows.push_back(on_surface("surface_distance", 64, 1, 0, [](const Surface &surface, const Context &context) {
        return surface.distance(curve_of(circle(31, 1.0, 4.0), 3), 0.0, context);
    }, "curve"));
}
} // namespace

std::vector<Row> operation_rows() {
    std::vector<Row> rows;
    add_net_rows(rows);
    add_joined_rows(rows);
    add_curve_rows(rows);
    add_surface_rows(rows);
    return rows;
}

} // namespace complexity
