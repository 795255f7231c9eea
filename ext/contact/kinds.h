// The pair kinds behind the door, one maker a file. `degree`: of the relative motion, at most 2.
#pragma once

#include "contact/pair_source.h"

namespace foresee {

std::unique_ptr<Contact> make_box_box(const Setup& setup, int degree);
std::unique_ptr<Contact> make_ball_ball(const Setup& setup, int degree);
std::unique_ptr<Contact> make_box_ball(const Setup& setup, int degree);
std::unique_ptr<Contact> make_cylinder_cylinder(const Setup& setup, int degree);
std::unique_ptr<Contact> make_cylinder_box(const Setup& setup, int degree);

// The first side is a window.
std::unique_ptr<Contact> make_window_box(const Setup& setup, int degree);
std::unique_ptr<Contact> make_window_ball(const Setup& setup, int degree);
std::unique_ptr<Contact> make_window_cylinder(const Setup& setup, int degree);

}  // namespace foresee
