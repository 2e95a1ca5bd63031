#include "core/kinds/robot/urdf_chain.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace covaria::urdf {

namespace {

constexpr std::size_t nobody = static_cast<std::size_t>(-1);
constexpr double gripper_stroke = 0.1;  // m: a joint at the end that slides by less is a gripper

bool called_a_finger(std::string name) {
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
    const bool grips = has("finger") || has("gripper") || has("knuckle") || has("jaw") || has("thumb");
    return grips && !(has("roll") || has("pitch") || has("yaw") || has("rot") || has("wrist"));
}

/// Place of a joint in the tree.
struct Place {
    std::size_t above = nobody;    ///< joint that holds its parent link
    std::size_t body = nobody;     ///< nearest joint above that is not fixed: what follows moves with it
    std::size_t blocked = nobody;  ///< first joint, itself or above, that an arm cannot have
    std::size_t last = nobody;     ///< last moving joint, itself or above
    std::size_t moving = 0;        ///< number of moving joints, itself and above
    std::size_t below = 0;         ///< most moving joints on a path below
    std::size_t depth = 0;
    Message gripper = {};  ///< why it is part of a gripper; empty: it is not
};

/// Says of joints why they are part of a gripper. `order`: each joint behind those above it.
void find_grippers(const std::vector<Joint>& joints, const std::vector<std::size_t>& order,
                   std::vector<Place>& places) {
    std::set<std::string> followed;
    for (const Joint& joint : joints) followed.insert(joint.follows);
    for (const std::size_t j : order) {
        const Joint& joint = joints[j];
        Place& place = places[j];
        if (!joint.moves()) continue;
        const bool at_end = place.below == 0 && place.moving > 2;
        const bool short_stroke = joint.limited && joint.high - joint.low < gripper_stroke;
        if (called_a_finger(joint.name))
            place.gripper = tell<"it is called like a joint of a gripper">();
        else if (at_end && followed.count(joint.name) > 0)
            place.gripper = tell<"others follow it at the end of the arm, as in a gripper">();
        else if (at_end && joint.kind == JointKind::sliding && short_stroke)
            place.gripper = tell<"it slides by less than 100 mm at the end of the arm, as in a gripper">();
    }
}

/// Several moving joints on one body, all with less behind them than the arm has before: fingers.
void find_forks(const std::vector<Joint>& joints, const std::vector<std::size_t>& order,
                std::vector<Place>& places) {
    std::map<std::size_t, std::vector<std::size_t>> leaving;
    for (const std::size_t j : order)
        if (joints[j].moves() && places[j].body != nobody) leaving[places[j].body].push_back(j);
    for (const auto& [body, fork] : leaving) {
        const std::size_t before = places[body].moving;
        const bool hand = fork.size() > 1 && std::all_of(fork.begin(), fork.end(), [&](std::size_t j) {
                              return places[j].below + 1 < before;
                          });
        for (const std::size_t j : fork)
            if (hand && places[j].gripper.empty())
                places[j].gripper = tell<"it is one of several at the end of the arm, as in a hand">();
    }
}

class Tree {
public:
    explicit Tree(const Robot& robot)
        : line_(robot.line), joints_(robot.joints), places_(robot.joints.size()) {
        sort();
        count();
        find_grippers(joints_, order_, places_);
        find_forks(joints_, order_, places_);
    }

    Result<Chain> longest() {
        find_obstacles();
        std::size_t most = 0;
        for (const std::size_t j : order_)
            if (places_[j].blocked == nobody) most = std::max(most, places_[j].moving);
        if (most == 0) return why_no_arm();
        std::vector<std::size_t> ends;
        for (const std::size_t j : order_)
            if (places_[j].blocked == nobody && places_[j].moving == most) ends.push_back(j);
        const auto end = preferred(ends);
        if (!end) return fail(end.error());
        return remarked(*end, chain(*end));
    }

    Result<Chain> to(const std::string& tip) const {
        const auto found = holder_.find(tip);
        if (found == holder_.end())
            return fail(ErrorCode::not_found, tell<"no joint leads to a link called %1">(tip));
        if (!sorted_[found->second]) return ring();
        Chain way = chain(found->second);
        std::size_t moving = 0;
        for (Joint& joint : way.joints) {
            if (joint.kind == JointKind::other) return refused_at(joint.line, obstacle_words(joint, tip));
            if (joint.moves() && called_a_finger(joint.name))
                joint.freeze(joint.limited ? std::clamp(0.0, joint.low, joint.high) : 0.0);
            moving += joint.moves();
        }
        if (moving == 0)
            return refused_at(joints_[found->second].line, tell<"no moving joint leads to %1">(tip));
        return remarked(found->second, std::move(way));
    }

private:
    /// Error at the first joint that nothing leads to.
    tl::unexpected<Error> ring() const {
        const auto first = std::find(sorted_.begin(), sorted_.end(), false) - sorted_.begin();
        return refused_at(joints_[static_cast<std::size_t>(first)].line,
                          tell<"the links form a ring; URDF describes trees">());
    }

    /// Words about a joint on the way to a named tip that an arm cannot have.
    static Message obstacle_words(const Joint& joint, const std::string& tip) {
        return joint.follows.empty()
                   ? tell<"joint %1 on the way to %2 is of the type %3: freeze it, --freeze %1=0">(
                         joint.name, tip, joint.type)
                   : tell<"joint %1 on the way to %2 follows joint %3: freeze it, --freeze %1=0">(
                         joint.name, tip, joint.follows);
    }

    Message why_no_arm_at(std::size_t j) const {
        const Joint& joint = joints_[j];
        if (!places_[j].gripper.empty())
            return tell<"no arm: joint %1 was left out because %2">(joint.name, places_[j].gripper);
        return joint.follows.empty() ? tell<"no arm: joint %1 is of the type %2">(joint.name, joint.type)
                                     : tell<"no arm: joint %1 follows joint %2">(joint.name, joint.follows);
    }

    Message why_left_out(std::size_t j, const std::string& tip) const {
        const Joint& joint = joints_[j];
        if (joint.kind == JointKind::other)
            return joint.follows.empty() ? tell<"left out: it is of the type %1">(joint.type)
                                         : tell<"left out: it follows joint %1">(joint.follows);
        if (!places_[j].gripper.empty()) return tell<"left out: %1">(places_[j].gripper);
        return tell<"left out: it is not on the way to %1">(tip);
    }

    /// Sorts each joint behind those above it; a joint that hangs on a ring is not reached.
    void sort() {
        std::map<std::string, std::vector<std::size_t>> by_parent;
        for (std::size_t j = 0; j < joints_.size(); ++j) {
            holder_[joints_[j].child] = j;
            by_parent[joints_[j].parent].push_back(j);
        }
        for (std::size_t j = 0; j < joints_.size(); ++j)
            if (const auto found = holder_.find(joints_[j].parent); found != holder_.end())
                places_[j].above = found->second;
            else
                order_.push_back(j);
        for (std::size_t k = 0; k < order_.size(); ++k)
            if (const auto found = by_parent.find(joints_[order_[k]].child); found != by_parent.end())
                order_.insert(order_.end(), found->second.begin(), found->second.end());
        sorted_.assign(joints_.size(), false);
        for (const std::size_t j : order_) sorted_[j] = true;
    }

    void count() {
        for (const std::size_t j : order_) {
            Place& place = places_[j];
            if (place.above != nobody) {
                const Place& above = places_[place.above];
                place.moving = above.moving;
                place.last = above.last;
                place.depth = above.depth + 1;
                place.body = joints_[place.above].kind == JointKind::fixed ? above.body : place.above;
            }
            if (!joints_[j].moves()) continue;
            ++place.moving;
            place.last = j;
        }
        for (auto k = order_.rbegin(); k != order_.rend(); ++k)
            if (const std::size_t above = places_[*k].above; above != nobody)
                places_[above].below =
                    std::max(places_[above].below, places_[*k].below + joints_[*k].moves());
    }

    void find_obstacles() {
        for (const std::size_t j : order_) {
            Place& place = places_[j];
            if (place.above != nobody) place.blocked = places_[place.above].blocked;
            const bool obstacle = joints_[j].kind == JointKind::other || !place.gripper.empty();
            if (place.blocked == nobody && obstacle) place.blocked = j;
        }
    }

    tl::unexpected<Error> why_no_arm() const {
        if (order_.size() < joints_.size()) return ring();
        for (const std::size_t j : order_)
            if (places_[j].blocked == j) return refused_at(joints_[j].line, why_no_arm_at(j));
        return refused_at(line_, tell<"the file has no moving joint">());
    }

    Result<std::size_t> preferred(const std::vector<std::size_t>& ends) const {
        for (const std::size_t end : ends)
            if (places_[end].last != places_[ends.front()].last)
                return refused_at(
                    joints_[end].line,
                    tell<"the file has several arms of equal length, ending at %1 and %2: name the tip link "
                         "of the one to import">(joints_[ends.front()].child, joints_[end].child));
        for (const char* wanted : {"tool0", "tcp", "flange"})
            for (const std::size_t end : ends)
                if (joints_[end].child.find(wanted) != std::string::npos) return end;
        return *std::max_element(ends.begin(), ends.end(), [&](std::size_t a, std::size_t b) {
            return places_[a].depth < places_[b].depth;
        });
    }

    /// The joints from the root of the tree to the link that joint `end` holds.
    Chain chain(std::size_t end) const {
        Chain chain{.root = {}, .tip = joints_[end].child};
        for (std::size_t j = end; j != nobody; j = places_[j].above) {
            chain.joints.push_back(joints_[j]);
            chain.root = joints_[j].parent;
        }
        std::reverse(chain.joints.begin(), chain.joints.end());
        return chain;
    }

    Chain remarked(std::size_t end, Chain chain) const {
        std::set<std::size_t> taken;
        for (std::size_t j = end; j != nobody; j = places_[j].above) taken.insert(j);
        for (std::size_t j = 0; j < joints_.size(); ++j) {
            const Joint& joint = joints_[j];
            const bool on_the_way = taken.count(j) > 0;
            if (joint.kind == JointKind::fixed) continue;
            if (on_the_way && joint.moves() && called_a_finger(joint.name))
                chain.remarks.push_back({joint.name, tell<"frozen: %1">(places_[j].gripper)});
            else if (!on_the_way)
                chain.remarks.push_back({joint.name, why_left_out(j, chain.tip)});
        }
        return chain;
    }

    int line_;
    const std::vector<Joint>& joints_;
    std::vector<Place> places_;
    std::vector<std::size_t> order_;
    std::vector<bool> sorted_;
    std::map<std::string, std::size_t> holder_;  ///< joint that holds a link
};

}  // namespace

Result<Chain> chain_to(const Robot& robot, const std::string& tip) {
    Tree tree(robot);
    return tip.empty() ? tree.longest() : tree.to(tip);
}

}  // namespace covaria::urdf
