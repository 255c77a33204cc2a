// Whether the block really moves as a closed form assumes, and what is against it.
#pragma once

#include <numerics/motion/ground_motion.hpp>
#include <numerics/search/forms.hpp>
#include <optional>
#include <string>

namespace rederive::numerics {

/// Why a root of a closed form is not a least amplitude. Times are p t.
struct Objection {
  enum class Kind {
    crest_comes_later,              ///< the phase of (103) asks for a cosine pulse that has passed its crest
    falls_from_start,               ///< the pulse falls from the start, and a block at rest does not move
    falls_from_start_or_goes_left,  ///< (78): the same, and a pulse that rises turns the block to theta < 0
    impact_too_late,                ///< (86)&(88): the impact, at `time`, is after the pulse ends, at `other`
    impact_too_early,    ///< (92a)&(96): the impact, at `time`, is before the pulse ends, at `other`
    stays_at_rest,       ///< the ground acceleration falls at once, and the block stays at rest
    starts_to_left,      ///< the motion starts with theta < 0, and the form assumes theta > 0
    starts_to_right,     ///< the other way round
    other_first_impact,  ///< the first impact is at `time`, not at `other`
    changes_sign,        ///< an impact at `time`, before the pulse ends; the form assumes none
    second_impact,       ///< a second impact at `time`, before the pulse ends
    upper_edge           ///< the block moves so, but overturns below the amplitude and not above
  };
  Kind kind;
  Real time = 0, other = 0;
};

/// The words for an objection: what is wrong, and further detail, which may be empty.
struct ObjectionWords {
  std::string brief, detail;

  /// Returns "brief: detail", or what there is of it.
  std::string in_full() const;
};
ObjectionWords words_for(const Objection& objection);

/// Returns why the block does not move as `form` says at `root`, or nothing if it does. The linear motion is
/// followed in balls. Throws NotCertain if their bits are too few.
std::optional<Objection> objection_to(Form form, Pulse pulse, const ExactCase& exact, const ExactRoot& root);

}  // namespace rederive::numerics
