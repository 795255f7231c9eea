#include "index/gpcd_grid/stripes.h"

#include "base/parallel.h"

namespace foresee::gpcd {

namespace {

/// Transposes columns of lanes to rows of `width` floats.
template <int width>
void write_rows(const float* const* columns, std::size_t count, float* out) {
  for (std::size_t l = 0; l < count; ++l, out += width)
    for (int k = 0; k < width; ++k) out[k] = columns[k][l];
}

}  // namespace

template <int D>
void FloatRows<D>::write(std::size_t first, const FloatLanes<D>& lanes, std::size_t count) {
  const float* columns[3 * D + 2];
  for (int k = 0; k < D; ++k) {
    columns[k] = lanes.lower[k];
    columns[D + k] = lanes.upper[k];
    columns[2 * D + k] = lanes.travel[k];
  }
  columns[3 * D] = lanes.begin, columns[3 * D + 1] = lanes.end;
  float* out = values_ + first * width_;
  if (columns_.life)
    write_rows<3 * D + 2>(columns, count, out);
  else if (columns_.travel)
    write_rows<3 * D>(columns, count, out);
  else
    write_rows<2 * D>(columns, count, out);
}

template class FloatRows<1>;
template class FloatRows<2>;
template class FloatRows<3>;

namespace {

constexpr std::size_t chunks_per_check = 64, entries_per_check = 8192;

}  // namespace

template <int D>
Stripes<D>::Stripes(const MovingSource<D>& source, const FloatFrame<D>& frame, const Partition<D>& partition,
                    FloatRows<D>& rows, GridSpace::Side& memory, std::size_t helpers, Interrupt& interrupt)
    : partition_(partition), rows_(rows), starts_(memory.stripes.room(partition.stripes() + 1)) {
  std::vector<Part> parts(helpers + 1);
  if (memory.parts.size() < parts.size()) memory.parts.resize(parts.size());
  const std::size_t count = source.count();
  run_together(helpers, interrupt, [&](std::size_t part, std::size_t of, Interrupt& own_interrupt) {
    collect_entries(source, frame, part * count / of, (part + 1) * count / of, memory.parts[part],
                    parts[part], own_interrupt);
  });
  add_up(parts);
  keys_ = memory.keys.room(entry_count_);
  run_together(helpers, interrupt, [&](std::size_t part, std::size_t, Interrupt& own_interrupt) {
    place(parts[part], own_interrupt);
  });
}

template <int D>
void Stripes<D>::collect_entries(const MovingSource<D>& source, const FloatFrame<D>& frame, std::size_t begin,
                                 std::size_t end, GridSpace::Part& memory, Part& part, Interrupt& interrupt) {
  part.counts = memory.counts.room(partition_.stripes());
  std::fill_n(part.counts, partition_.stripes(), 0);
  const FloatKernels<D>& kernels = float_kernels<D>();
  BeamLanes<D> beams;
  FloatLanes<D> lanes;
  std::size_t chunks = 0;
  for (std::size_t first = begin; first < end; first += lanes.width) {
    if (chunks++ % chunks_per_check == 0) interrupt.check();
    const std::size_t count = std::min(lanes.width, end - first);
    source.read(first, count, beams);
    kernels.round_outward(beams, count, frame, rows_.columns(), lanes);
    kernels.find_stripes(lanes, count, partition_);
    rows_.write(first, lanes, count);
    add_entries(lanes, first, count, memory, part);
  }
}

// Most boxes meet one or two stripes along an axis; that case takes no branch.
template <int D>
void Stripes<D>::add_entries(const FloatLanes<D>& lanes, std::size_t first, std::size_t count,
                             GridSpace::Part& memory, Part& part) const {
  // The branch-free case writes up to four entries, some of which are overwritten.
  std::size_t wanted = part.size + 4;
  std::uint32_t any_giant = 0;
  for (std::size_t l = 0; l < count; ++l) {
    wanted += std::size_t{lanes.more_y[l] + 1} * (lanes.more_z[l] + 1);
    any_giant |= lanes.giant[l];
  }
  Key* const keys = part.keys = memory.keys.grown(wanted, part.size);
  std::uint32_t* const stripes = part.stripes = memory.stripes.grown(wanted, part.size);
  const auto across = static_cast<std::uint32_t>(D > 2 ? partition_.axis[D - 1].count : 1);
  std::size_t size = part.size;
  for (std::size_t l = 0; l < count; ++l) {
    const Key key = Key{lanes.order[l]} << 32 | static_cast<std::uint32_t>(first + l);
    const std::uint32_t stripe = lanes.first[l], y = lanes.more_y[l], z = lanes.more_z[l];
    keys[size] = key, stripes[size] = stripe, size += lanes.inside[l];
    if (y <= 1 && z <= 1) {
      if constexpr (D > 2) {
        keys[size] = key, stripes[size] = stripe + 1, size += z;
        keys[size] = key, stripes[size] = stripe + across + 1, size += y & z;
      }
      if constexpr (D > 1) keys[size] = key, stripes[size] = stripe + across, size += y;
      continue;
    }
    for (std::uint32_t j = 0; j <= y; ++j)
      for (std::uint32_t k = j == 0; k <= z; ++k)
        keys[size] = key, stripes[size] = stripe + j * across + k, ++size;
  }
  for (std::size_t i = part.size; i < size; ++i) ++part.counts[stripes[i]];
  part.size = size;
  for (std::size_t l = 0; any_giant && l < count; ++l)
    if (lanes.giant[l]) part.giants.push_back(static_cast<std::uint32_t>(first + l));
}

// Counts become the positions of each part's first entry in each stripe.
template <int D>
void Stripes<D>::add_up(std::span<Part> parts) {
  for (const Part& part : parts) {
    entry_count_ += part.size;
    giants_.insert(giants_.end(), part.giants.begin(), part.giants.end());
  }
  if (entry_count_ > std::numeric_limits<std::uint32_t>::max()) throw Error("too many objects for one grid");
  std::uint32_t place = 0;
  for (std::size_t stripe = 0; stripe < partition_.stripes(); ++stripe) {
    starts_[stripe] = place;
    for (Part& part : parts) place += std::exchange(part.counts[stripe], place);
  }
  starts_[partition_.stripes()] = place;
}

template <int D>
void Stripes<D>::place(Part& part, Interrupt& interrupt) {
  for (std::size_t i = 0; i < part.size; ++i) {
    if (i % entries_per_check == 0) interrupt.check();
    keys_[part.counts[part.stripes[i]]++] = part.keys[i];
  }
}

template class Stripes<1>;
template class Stripes<2>;
template class Stripes<3>;

}  // namespace foresee::gpcd
