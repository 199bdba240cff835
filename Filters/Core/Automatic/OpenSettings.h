// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file OpenSettings.h
 * @brief The settings of a method that the data choose, and the search for their values.
 *
 * Properties of filters say it with a number: 0 opens a setting, any other value closes it. What
 * judges the values, on a mesh or on a point set, is in MeshTuning.h and CloudTuning.h.
 */

#ifndef SurfaceDenoising_OpenSettings_h
#define SurfaceDenoising_OpenSettings_h

#include "../Execution.h"

#include <string>

namespace SurfaceDenoising
{

/// A setting that the data choose.
struct OpenSetting
{
  std::string Name;       ///< of the property
  double* Real = nullptr; ///< where the setting is, if it is a real number
  double* Tied = nullptr; ///< another setting that has the same value, if there is one
  int* Count = nullptr;   ///< where it is, if it is a count
  double Unit = 1.0;      ///< setting = value of the property * Unit
  double Power = 0.0;     ///< time grows with that power of the setting
  double Start = 0.0;     ///< where the search starts
  double Least = 0.0;     ///< of the setting
  double Most = 0.0;
  double Chosen = 0.0; ///< value of the property after the choice

  double Get() const { return this->Real ? *this->Real : double(*this->Count); }
  void Set(double value);

  /// The value after this one in the first or second round (0 or 1) of the search.
  double Next(double value, int round, bool up) const;
};

class OpenSettings
{
public:
  /// Forgets settings and chosen values.
  void Clear() { this->Settings.clear(); }

  /**
   * Gives a setting the value of a property times the unit, or, if that is 0, opens it: the search
   * starts from the value that the setting has, or from start if that is not 0, and stays within a
   * factor of 8. The setting must stay where it is until the search is over. least bounds values
   * from below, given ones as well.
   */
  void Take(const char* name, double value, double& setting, double unit = 1.0, double least = 0.0,
    double start = 0.0);

  /// The same for a count, which is at least `least` if it is open. Negative values mean none, 0.
  void Take(const char* name, int value, int& setting, int least = 1);

  /// The same for the radius of neighbourhoods, which the search keeps below most.
  void TakeRadius(const char* name, double value, double& setting, double most);

  /// The same for the scale of a Gaussian of distances, in whose place 0 means no Gaussian, as
  /// negative values of the property do.
  void TakeSpatial(const char* name, double value, double& setting, double least = 0.0);

  /// A setting that always has the value of another one, which was taken before.
  void Tie(const double& setting, double& other);

  /// The value of a property for a setting that TakeSpatial takes: -1 for 0.
  static double SpatialProperty(double setting) { return setting > 0.0 ? setting : -1.0; }

  /// A setting that does not matter keeps the value that it has.
  void Close(const std::string& name);

  bool Any() const { return !this->Settings.empty(); }

  const std::vector<OpenSetting>& All() const { return this->Settings; }

  /// The chosen value of a property; NaN if it was given.
  double Chosen(const std::string& name) const;

  /// Keeps what the settings are now, as chosen values.
  void Keep();

  /// What is asked of those who judge values.
  class Judge
  {
  public:
    virtual ~Judge() = default;
    /// Tries the settings as they are now. Returns false if the execution asked to stop.
    virtual bool Try(Execution& execution) = 0;
    /// How bad each of the tries so far is beside the others.
    virtual std::vector<double> Costs() const = 0;
    /// The numbers of the tries so far, best first.
    std::vector<std::size_t> Ranking() const;
  };

  /**
   * Looks for the best values, coordinate by coordinate: as long as it pays, a setting goes on by a
   * factor of 1.5 (counts: of 2) in one direction or the other, and again by smaller factors; then
   * settings hold the best values tried. Numbers of iterations and radii are limited together, to
   * about four times the time that the start takes. At most 6 + 4 n tries for n settings. Returns
   * false if the execution asked to stop.
   */
  bool Search(Judge& judge, Execution& execution);

  /**
   * Tries the values again that the search started from and the best four that it found, for a
   * judge who is more exact, and keeps the best of these. Returns false if the execution asked to
   * stop.
   */
  bool Confirm(const Judge& before, Judge& judge, Execution& execution);

private:
  using Values = std::vector<double>;

  /// How much longer these values take than those of the start, about.
  double Cost(const Values& values) const;
  Values Get() const;
  void Set(const Values& values);

  std::vector<OpenSetting> Settings;
  std::vector<Values> Tried; ///< in the last search
};

}

#endif
