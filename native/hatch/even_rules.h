// Every length by which even_hatches places, in spacings, in one table.
//
// A new streamline needs `clear` of its seed, ends `test` from a parallel one, and is no shorter
// than `least` (GrowRules). Relaxation parts those that are too near, so what is placed before it
// may be, and what is placed after it may not. docs/sensitivity.md tells what drawings make of half
// and double of each.
#pragma once

#include "hatch/streamlines/grow_streamlines.h"
#include "hatch/streamlines/place_curves.h"

namespace illustrate {

struct EvenRules {
  // --- What placing starts from ---

  // Of the curves that a view starts from; finer ones would find no room.
  double finest_radius = 0.8;
  // How far beyond where they are wanted hatches are placed: of the family that stays, and of the
  // other one. Edges of tone move with the light and the eye, and what starts there would start
  // anew in each frame.
  double midtone_margin = 8, shadow_margin = 3;

  // --- A drawing that stands alone ---

  // Gaps between ranked curves before they are relaxed: wide ones, for streamlines will still be
  // moved into the others. Half of `wide_clear` fills what relaxation would have, and crowds: twice
  // as many points are too near another hatch.
  double wide_clear = 0.9, wide_test = 0.6, wide_least = 1.5;
  // Sweeps of relaxation, in which streamlines find their places, and after the gaps left by that
  // are filled. Half leaves the next frame more to even out, double gains nothing.
  int first_sweeps = 5, last_sweeps = 2;
  // Relaxed streamlines lose what is nearer; what is left is longer, or it goes. Twice `cut_test`,
  // a spacing, cuts what is even, and in each frame elsewhere.
  double cut_test = 0.5, first_least = 1.5, last_least = 1;
  // Ends go on after the first cut. Half lets them run into others: the worst of all changes here
  // but that of tips.
  double extend_test = 0.65;
  // Gaps after that.
  double gap_clear = 0.75, gap_test = 0.55, gap_least = 1;
  // Short streamlines go where neighbours are within this (thin_streamlines.h): before the last
  // relaxation, which closes wider gaps, and at the end.
  double first_thin = 1.1, last_thin = 1;

  // --- A drawing that follows another ---

  // What the last one placed is placed again down to these distances and lengths: less than is
  // asked of anything new, so that it stays. A place is `clear` where it passes `test`, too: with
  // `kept_clear` below `kept_test`, as at twice this or half of that, a third of all hatches move.
  double kept_test = 0.5, kept_clear = 0.5, kept_least = 0.5;
  // Gaps that have opened. With more clear room wide gaps last, beside what has not yet filled.
  double new_clear = 0.7, new_test = 0.6, new_least = 1.5;
  // Surfaces that turn away from the eye crowd what was placed, frame after frame: relaxed
  // streamlines lose what is nearer, once in a frame. With `cut_test`, enough for a drawing that
  // stands alone, a sequence is a fifth less even than a still after twenty frames; with more,
  // frames hold less still, and no more even.
  double crowded_test = 0.65;
  // What the last drawing placed stays unless it has become uneven by so much. Half of it moves
  // twice as much of what could stay, with twice of it frames are less even after a while.
  double least_move = 0.04;

  // --- Ends ---

  // Ends go on to what ends them, in fine steps less clear of others than in whole ones. Half of
  // `tip_step_test` crowds most of all; twice `tip_test` leaves hatches more even, but fewer.
  double tip_step_test = 0.7, tip_test = 0.59;
  // What is left then: gaps of the surface's seeds, and narrow strips along critical curves, where
  // short hatches are part of a whole.
  double rest_clear = 0.77, rest_test = 0.55, rest_least = 0.75;
  double strip_clear = 0.75, strip_test = 0.5, strip_least = 0.4;
  // Tips that no bridge has joined to anything.
  double least_tip = 0.5;

  GrowRules wide_gaps() const { return {wide_clear, wide_test, wide_least}; }
  GrowRules gaps() const { return {gap_clear, gap_test, gap_least}; }
  GrowRules new_gaps() const { return {new_clear, new_test, new_least}; }
  GrowRules rests() const { return {rest_clear, rest_test, rest_least}; }
  GrowRules strips() const { return {strip_clear, strip_test, strip_least}; }
  PlaceRules kept() const {
    PlaceRules rules{kept_test, kept_clear, kept_least};
    rules.straight = true;  // they were relaxed off the cross
    rules.holds = true;
    return rules;
  }
};

inline constexpr EvenRules even_rules;

}  // namespace illustrate
