// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OpenSettings.h"

#include "ProgressShare.h"

#include <cmath>
#include <limits>

namespace SurfaceDenoising
{

namespace
{

/// How far from where it started a setting may go, as a factor. What more iterations cost is time.
constexpr double RealReach = 8.0;
constexpr double CountReach = 4.0;

/// Factors of the steps, first and second round.
constexpr double RealSteps[] = { 1.5, 1.2 };
constexpr double CountSteps[] = { 2.0, 1.4 };

using Values = std::vector<double>;

/// The search in progress.
class Walk
{
public:
  Walk(std::vector<OpenSetting>& settings, OpenSettings::Judge& judge, Execution& execution)
    : Settings(settings)
    , Verdict(judge)
    , Exec(execution)
    , Limit(6 + 4 * settings.size())
  {
  }

  /// False if the execution asked to stop.
  bool Run()
  {
    Values start;
    for (const OpenSetting& setting : this->Settings)
    {
      start.push_back(setting.Get());
    }
    if (!this->Visit(start))
    {
      return false;
    }
    for (int round = 0; round < 2; ++round)
    {
      for (std::size_t s = 0; s < this->Settings.size(); ++s)
      {
        const std::size_t before = this->Verdict.Best();
        if (!this->Follow(s, round, true) ||
          (this->Verdict.Best() == before && !this->Follow(s, round, false)))
        {
          return false;
        }
      }
    }
    this->Enter(this->Tried[this->Verdict.Best()]);
    return true;
  }

private:
  void Enter(const Values& values)
  {
    for (std::size_t s = 0; s < values.size(); ++s)
    {
      this->Settings[s].Set(values[s]);
    }
  }

  bool Visit(const Values& values)
  {
    this->Enter(values);
    const double part = 1.0 / double(this->Limit);
    const double done = double(this->Tried.size()) * part;
    ProgressShare share(this->Exec, done, done + part);
    this->Tried.push_back(values);
    return this->Verdict.Try(share);
  }

  /// One setting in one direction, as long as it pays.
  bool Follow(std::size_t s, int round, bool up)
  {
    const OpenSetting& setting = this->Settings[s];
    while (this->Tried.size() < this->Limit)
    {
      Values next = this->Tried[this->Verdict.Best()];
      const double factor = setting.Real ? RealSteps[round] : CountSteps[round];
      const double old = next[s];
      next[s] = up ? old * factor : old / factor;
      if (setting.Count)
      {
        next[s] = up ? std::max(old + 1.0, std::round(next[s])) : std::floor(next[s]);
      }
      next[s] = std::min(setting.Most, std::max(setting.Least, next[s]));
      if (std::find(this->Tried.begin(), this->Tried.end(), next) != this->Tried.end())
      {
        return true;
      }
      if (!this->Visit(next))
      {
        return false;
      }
      if (this->Verdict.Best() + 1 != this->Tried.size())
      {
        return true;
      }
    }
    return true;
  }

  std::vector<OpenSetting>& Settings;
  OpenSettings::Judge& Verdict;
  Execution& Exec;
  const std::size_t Limit;
  std::vector<Values> Tried;
};

}

void OpenSetting::Set(double value)
{
  if (this->Real)
  {
    *this->Real = value;
    if (this->Tied)
    {
      *this->Tied = value;
    }
  }
  else
  {
    *this->Count = static_cast<int>(value);
  }
}

void OpenSettings::Take(const char* name, double value, double& setting, double unit, double least,
  double start, double most)
{
  if (value != 0.0)
  {
    setting = std::max(least, value * unit);
    return;
  }
  setting = start != 0.0 ? start : setting;
  OpenSetting open;
  open.Name = name;
  open.Real = &setting;
  open.Unit = unit;
  open.Least = std::max(least, setting / RealReach);
  open.Most = most > 0.0 ? std::min(most, setting * RealReach) : setting * RealReach;
  this->Settings.push_back(open);
}

void OpenSettings::Take(const char* name, int value, int& setting, int least)
{
  if (value != 0)
  {
    setting = std::max(0, value);
    return;
  }
  setting = std::max(least, setting);
  OpenSetting open;
  open.Name = name;
  open.Count = &setting;
  open.Least = std::max(double(least), std::floor(setting / CountReach));
  open.Most = setting * CountReach;
  this->Settings.push_back(open);
}

void OpenSettings::TakeSpatial(const char* name, double value, double& setting, double least)
{
  if (value < 0.0)
  {
    setting = 0.0;
    return;
  }
  this->Take(name, value, setting, 1.0, least, setting > 0.0 ? 0.0 : 1.0);
}

void OpenSettings::Tie(const double& setting, double& other)
{
  other = setting;
  for (OpenSetting& open : this->Settings)
  {
    open.Tied = open.Real == &setting ? &other : open.Tied;
  }
}

void OpenSettings::Close(const std::string& name)
{
  this->Settings.erase(std::remove_if(this->Settings.begin(), this->Settings.end(),
                         [&](const OpenSetting& setting) { return setting.Name == name; }),
    this->Settings.end());
}

double OpenSettings::Chosen(const std::string& name) const
{
  for (const OpenSetting& setting : this->Settings)
  {
    if (setting.Name == name)
    {
      return setting.Chosen;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void OpenSettings::Keep()
{
  for (OpenSetting& setting : this->Settings)
  {
    setting.Chosen = setting.Get() / setting.Unit;
  }
}

bool OpenSettings::Search(Judge& judge, Execution& execution)
{
  return Walk(this->Settings, judge, execution).Run();
}

}
