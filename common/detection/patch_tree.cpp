#include "common/detection/patch_tree.h"

#include <fcl/broadphase/detail/hierarchy_tree.h>
#include <fcl/math/bv/AABB.h>

namespace trocar {
namespace {

using BoxTree = fcl::detail::HierarchyTree<fcl::AABBd>;
using Node = BoxTree::NodeType;

fcl::AABBd fcl_box(const Box& box) { return {box.low, box.high}; }

void find_below(const Node* node, const fcl::AABBd& box, std::vector<std::uint32_t>& found) {
    if (!node->bv.overlap(box)) return;
    if (node->isLeaf()) {
        found.push_back(*static_cast<const std::uint32_t*>(node->data));
        return;
    }
    find_below(node->children[0], box, found);
    find_below(node->children[1], box, found);
}

}  // namespace

struct PatchTree::Tree {
    BoxTree boxes;
    std::vector<Node*> leaves;
    std::vector<std::uint32_t> numbers;  // that the leaves point to
};

PatchTree::PatchTree(std::span<const Box> boxes) : tree_(std::make_unique<Tree>()) {
    for (std::uint32_t k = 0; k < boxes.size(); ++k) tree_->numbers.push_back(k);
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
        tree_->leaves.push_back(tree_->boxes.insert(fcl_box(boxes[k]), &tree_->numbers[k]));
    }
    tree_->boxes.balanceTopdown();
}

PatchTree::~PatchTree() = default;

void PatchTree::set(std::uint32_t number, const Box& box) {
    Node* node = tree_->leaves[number];
    node->bv = fcl_box(box);
    while ((node = node->parent) != nullptr) {
        const fcl::AABBd both = node->children[0]->bv + node->children[1]->bv;
        if (both.min_ == node->bv.min_ && both.max_ == node->bv.max_) return;  // equal() of FCL is not exact
        node->bv = both;
    }
}

void PatchTree::find(const Box& box, std::vector<std::uint32_t>& found) const {
    if (const Node* root = tree_->boxes.getRoot()) find_below(root, fcl_box(box), found);
}

}  // namespace trocar
