// The response of the block: arcs joined by impacts, rest and restart.
#pragma once

#include <numerics/motion/history.hpp>
#include <vector>

namespace rederive::numerics {

/// Returns the response of the block, from `initial`, to the ground motion. After an impact the velocity is e
/// times the velocity before it, (34), on the other side. Ever smaller impacts end in rest as soon as the
/// rest of the chain is too small to matter and over before the ground can start the block again; a resting
/// block starts when |ground| rises above start_level. After 5000 impacts, hops slower than 1e-4 alpha p
/// count as rest even if e = 1. Throws std::runtime_error after 500000 impacts, and a thousand more for each
/// piece of the ground motion.
Response respond(const Block& block, Model model, const GroundMotion& motion, const InitialState& initial,
                 const ResponseOptions& options = {});

/// A state of the block, and the ground acceleration in units of alpha g.
struct Sample {
  Real time, angle, velocity, ground;
};

/// Returns the states of a response, which has a history, at `count` >= 2 times evenly from 0 to `until`;
/// fewer if the block lies before.
std::vector<Sample> sampled(const GroundMotion& motion, const Response& response, Real until, int count);

}  // namespace rederive::numerics
