// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridText.h"

#include "Common/Text/LineErrors.h"
#include "Common/Text/StreamProgress.h"
#include "HeaderFields.h"
#include "Readers/HorizonText/PickBlock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
GridText::GridText(
  std::istream& stream, const Monitor& monitor, std::size_t bufferSize, const NullValues& nulls, bool hasDecimalCommas)
  : BytesInStream(CountBytes(stream))
  , Lines(stream, bufferSize)
  , Work(monitor)
  , Nulls(nulls)
  , HasDecimalCommas(hasDecimalCommas)
{
}

//----------------------------------------------------------------------------------------------------------------------
bool GridText::Fill()
{
  if (this->Lines.AtEnd())
  {
    return false;
  }
  if (!this->Lines.Read())
  {
    throw this->Error("reading failed, expected the rest of the file");
  }
  this->Text = this->Lines.First();
  this->Last = this->Lines.Last();
  if (this->HasDecimalCommas)
  {
    this->Converted = WithDecimalPoints({ this->Text, static_cast<std::size_t>(this->Last - this->Text) });
    this->Text = this->Converted.data();
    this->Last = this->Text + this->Converted.size();
  }
  if (this->IsFresh)
  {
    const std::string_view text(this->Text, static_cast<std::size_t>(this->Last - this->Text));
    this->Text = WithoutByteOrderMark(text).data();
    this->IsFresh = false;
  }
  this->Work.Progress(this->Lines.PartRead());
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<std::string_view> GridText::PeekLine()
{
  if (this->Text == this->Last && !this->Fill())
  {
    return {};
  }
  return std::string_view(this->Text, static_cast<std::size_t>(std::find(this->Text, this->Last, '\n') - this->Text));
}

//----------------------------------------------------------------------------------------------------------------------
void GridText::NextLine()
{
  if (const std::optional<std::string_view> line = this->PeekLine())
  {
    this->Text = line->data() + line->size() + 1;
    ++this->LineNumber;
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::string_view GridText::Word(const std::string& name)
{
  if (!this->FindWord())
  {
    throw this->EndError(name);
  }
  const std::string_view word = TokenAt(this->Text);
  this->Text += word.size();
  return word;
}

//----------------------------------------------------------------------------------------------------------------------
double GridText::Number(const std::string& name)
{
  const std::string_view word = this->Word(name);
  return ReadHeaderNumber(word, name, this->Place());
}

//----------------------------------------------------------------------------------------------------------------------
int GridText::Count(const std::string& name)
{
  const std::string_view word = this->Word(name);
  return ReadHeaderCount(word, name, this->Place());
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<double> GridText::Values(std::int64_t count, const NullRule& isNull)
{
  std::vector<double> values;
  values.reserve(this->Room(count));
  for (std::int64_t n = 0; n < count; ++n)
  {
    if (!this->FindWord())
    {
      throw this->EndError(n, count);
    }
    double z = 0.0;
    if (const char* const last = ReadPlainNumber(this->Text, z))
    {
      this->Text = last;
      values.push_back(isNull(z) ? std::numeric_limits<double>::quiet_NaN() : z);
    }
    else
    {
      const std::string_view word = TokenAt(this->Text);
      values.push_back(ReadGridValue(word, isNull, *this));
      this->Text += word.size();
    }
  }
  return values;
}

//----------------------------------------------------------------------------------------------------------------------
/// A file that ends with a newline has an additional empty line.
FileError GridText::EndError(const std::string& expected) const
{
  return CutOffAt(std::max<std::int64_t>(this->LineNumber - 1, 1), "end of file, expected " + expected);
}

//----------------------------------------------------------------------------------------------------------------------
FileError GridText::EndError(std::int64_t found, std::int64_t expected) const
{
  return CutOffAt(this->LineNumber - 1,
    "end of file after " + std::to_string(found) + " values, expected " + std::to_string(expected));
}

//----------------------------------------------------------------------------------------------------------------------
void GridText::RequireEnd(std::string_view comments)
{
  while (this->FindWord())
  {
    if (comments.find(*this->Text) == std::string_view::npos)
    {
      throw this->Error(Quote(TokenAt(this->Text)) + " after the last value, expected the end of the file");
    }
    this->NextLine();
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t GridText::Room(std::int64_t count) const
{
  constexpr double leastBytesPerValue = 2.0; // One digit and one separator.
  return static_cast<std::size_t>(std::min(static_cast<double>(count), this->BytesInStream / leastBytesPerValue));
}

//----------------------------------------------------------------------------------------------------------------------
double ReadGridValue(std::string_view word, const NullRule& isNull, const GridText& text)
{
  double z = 0.0;
  const NumberKind kind = ReadGridNumber(word, z);
  if (kind == NumberKind::NotANumber && !text.IsNull(word))
  {
    throw text.Error("value " + Quote(word) + ", expected a number; NullValues lists words for no value");
  }
  if (kind == NumberKind::NotANumber || isNull(z))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (kind == NumberKind::NotFinite)
  {
    throw text.Error("value " + Quote(word) + ", expected a finite number");
  }
  return z;
}
}
