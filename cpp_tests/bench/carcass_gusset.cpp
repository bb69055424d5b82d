// gusset, through its C interface.
#include "carcass.hpp"

#include <gusset.h>

namespace carcass {
namespace {
class Gusset : public Solver {
public:
    explicit Gusset(unsigned threads) {
        check(gusset_context_create(&context_));
        check(gusset_context_set_threads(context_, threads));
    }
    ~Gusset() override {
        forget();
        gusset_context_destroy(context_);
    }
    void prepare() override { forget(); }
    void build() override {
        make_sheet();
        const gusset_sheet *const sheets[] = {sheet_};
        check(gusset_carcass_create(context_, sheets, 1, nullptr, &carcass_));
    }

protected:
    virtual void make_sheet() = 0;

    void check(gusset_status status) const {
        if (status != GUSSET_OK) {
            throw std::runtime_error(gusset_status_text(status));
        }
    }
    void forget() {
        gusset_carcass_destroy(carcass_);
        gusset_sheet_destroy(sheet_);
        carcass_ = nullptr;
        sheet_ = nullptr;
    }

    gusset_context *context_ = nullptr;
    gusset_sheet *sheet_ = nullptr;
    gusset_carcass *carcass_ = nullptr;
};

class OfNodes final : public Gusset {
public:
    OfNodes(const Nodes &nodes, unsigned threads) : Gusset(threads), nodes_(nodes) {}

private:
    void make_sheet() override {
        gusset_nodes given{};
        given.struct_size = sizeof given;
        given.nodes = nodes_.points.data();
        given.rows = nodes_.rows;
        given.columns = nodes_.columns;
        given.scalar = GUSSET_F64;
        given.closed_u = given.closed_v = nodes_.closed ? 1 : 0;
        check(gusset_sheet_borrow(context_, &given, &sheet_));
    }

    const Nodes &nodes_;
};
} // namespace

std::unique_ptr<Solver> gusset(const Nodes &nodes, unsigned threads) { return std::make_unique<OfNodes>(nodes, threads); }
} // namespace carcass
