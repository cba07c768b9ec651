/// \file
/// The whole public interface of Kinegraph.
///
/// \code
/// const auto file = kinegraph::MechanismFile::open("four_bar.json");
/// const auto solved = file->solve();
/// const double omega = solved->value("omega 3")->value;       // rad/s
/// const std::string svg = kinegraph::draw(*solved)->svg()[0];  // the worked solution
/// \endcode
#pragma once

/// Planar mechanisms, solved exactly by the textbook's constructions and drawn to scale.
namespace kinegraph {}

#include <kinegraph/error.hpp>
#include <kinegraph/mechanism.hpp>
#include <kinegraph/motion.hpp>
#include <kinegraph/picture.hpp>
#include <kinegraph/request.hpp>
#include <kinegraph/sheet.hpp>
#include <kinegraph/solution.hpp>
#include <kinegraph/variants.hpp>
#include <kinegraph/version.hpp>
