// SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OpenSettings.h"

#include "ProgressShare.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace SurfaceDenoising
{

namespace
{

/// How far from where it started a setting may go, as a factor.
constexpr double Reach = 8.0;

/// How much longer than at the start the method may take, as a factor.
constexpr double MostCost = 4.0;

/// Factors of the steps, first and second round.
constexpr double RealSteps[] = { 1.5, 1.2 };
constexpr double CountSteps[] = { 2.0, 1.4 };

/// Tries that are confirmed, beside the start.
constexpr std::size_t MostConfirmed = 4;

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

double OpenSetting::Next(double value, int round, bool up) const
{
  const double factor = this->Real ? RealSteps[round] : CountSteps[round];
  double next = up ? value * factor : value / factor;
  if (this->Count)
  {
    next = up ? std::max(value + 1.0, std::round(next)) : std::floor(next);
  }
  return std::min(this->Most, std::max(this->Least, next));
}

void OpenSettings::Take(const char* name, double value, double& setting, double unit, double least,
  double start)
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
  open.Start = setting;
  open.Least = std::max(least, setting / Reach);
  open.Most = setting * Reach;
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
  open.Power = 1.0;
  open.Start = setting;
  open.Least = std::max(double(least), std::floor(setting / Reach));
  open.Most = setting * Reach;
  this->Settings.push_back(open);
}

void OpenSettings::TakeRadius(const char* name, double value, double& setting, double most)
{
  this->Take(name, value, setting);
  if (value == 0.0)
  {
    this->Settings.back().Power = 2.0;
    this->Settings.back().Most = most;
  }
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

double OpenSettings::Cost(const Values& values) const
{
  double cost = 1.0;
  for (std::size_t s = 0; s < values.size(); ++s)
  {
    cost *= std::pow(values[s] / this->Settings[s].Start, this->Settings[s].Power);
  }
  return cost;
}

OpenSettings::Values OpenSettings::Get() const
{
  Values values;
  for (const OpenSetting& setting : this->Settings)
  {
    values.push_back(setting.Get());
  }
  return values;
}

void OpenSettings::Set(const Values& values)
{
  for (std::size_t s = 0; s < values.size(); ++s)
  {
    this->Settings[s].Set(values[s]);
  }
}

std::vector<std::size_t> OpenSettings::Judge::Ranking() const
{
  const std::vector<double> costs = this->Costs();
  std::vector<std::size_t> order(costs.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return costs[a] < costs[b]; });
  return order;
}

bool OpenSettings::Search(Judge& judge, Execution& execution)
{
  const std::size_t limit = 6 + 4 * this->Settings.size();
  auto visit = [&](const Values& values)
  {
    const double part = 1.0 / double(limit);
    const double done = double(this->Tried.size()) * part;
    ProgressShare share(execution, done, done + part);
    this->Set(values);
    this->Tried.push_back(values);
    return judge.Try(share);
  };
  // One setting in one direction, as long as it pays. False if the execution asked to stop.
  auto follow = [&](std::size_t s, int round, bool up)
  {
    while (this->Tried.size() < limit)
    {
      Values next = this->Tried[judge.Ranking().front()];
      next[s] = this->Settings[s].Next(next[s], round, up);
      if (this->Cost(next) > MostCost ||
        std::find(this->Tried.begin(), this->Tried.end(), next) != this->Tried.end())
      {
        return true;
      }
      if (!visit(next))
      {
        return false;
      }
      if (judge.Ranking().front() + 1 != this->Tried.size())
      {
        return true;
      }
    }
    return true;
  };
  this->Tried.clear();
  if (!visit(this->Get()))
  {
    return false;
  }
  for (int round = 0; round < 2; ++round)
  {
    for (std::size_t s = 0; s < this->Settings.size(); ++s)
    {
      const std::size_t before = judge.Ranking().front();
      if (!follow(s, round, true) ||
        (judge.Ranking().front() == before && !follow(s, round, false)))
      {
        return false;
      }
    }
  }
  this->Set(this->Tried[judge.Ranking().front()]);
  return true;
}

bool OpenSettings::Confirm(const Judge& before, Judge& judge, Execution& execution)
{
  std::vector<std::size_t> again = before.Ranking();
  again.resize(std::min(again.size(), MostConfirmed));
  if (std::find(again.begin(), again.end(), std::size_t(0)) == again.end())
  {
    again.push_back(0);
  }
  for (std::size_t k = 0; k < again.size(); ++k)
  {
    ProgressShare share(execution, double(k) / double(again.size()),
      double(k + 1) / double(again.size()));
    this->Set(this->Tried[again[k]]);
    if (!judge.Try(share))
    {
      return false;
    }
  }
  this->Set(this->Tried[again[judge.Ranking().front()]]);
  return true;
}

}
