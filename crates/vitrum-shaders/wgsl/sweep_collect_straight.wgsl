struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_11 {
member: u32,
member_1: u32,
}
struct type_12 {
member: type_11,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_13 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_14 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_11,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_11,
member_18: type_12,
member_19: type_5,
member_20: type_13,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
member: array<u32>,
}
struct type_21 {
member: vec3<f32>,
member_1: f32,
}
struct type_22 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_23 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_24 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: i32,
member_10: i32,
member_11: type_2,
member_12: u32,
member_13: type_2,
member_14: u32,
member_15: u32,
}
struct type_25 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_26 {
member: type_5,
member_1: type_5,
}
struct type_27 {
member: type_7,
member_1: u32,
}
struct type_28 {
member: type_2,
member_1: u32,
member_2: type_22,
member_3: type_11,
member_4: type_11,
member_5: u32,
member_6: u32,
member_7: type_23,
member_8: type_24,
member_9: type_24,
member_10: type_25,
member_11: type_26,
member_12: type_14,
member_13: type_23,
member_14: type_4,
member_15: type_9,
member_16: type_27,
member_17: type_27,
member_18: type_27,
member_19: type_27,
member_20: type_10,
member_21: f32,
member_22: f32,
member_23: type_6,
}
struct type_29 {
member: type_28,
}
var<private> global: vec3<u32>;
@group(0) @binding(4)
var<storage, read_write> global_1: type_16;
@group(0) @binding(0)
var<storage> global_2: type_29;
@group(0) @binding(2)
var<storage> global_3: type_16;
@group(0) @binding(1)
var<storage> global_4: type_20;
@group(0) @binding(3)
var<storage> global_5: type_20;
fn function_() {
var phi_1714_: u32;
var phi_1715_: u32;
var phi_276_: i32;
var phi_453_: f32;
var phi_487_: f32;
var phi_522_: f32;
var phi_557_: f32;
var phi_667_: f32;
var phi_721_: i32;
var phi_765_: i32;
var phi_891_: vec3<f32>;
var phi_946_: i32;
var phi_1075_: vec3<f32>;
var phi_1110_: i32;
var phi_1238_: vec3<f32>;
var phi_1285_: i32;
var phi_1413_: vec3<f32>;
var phi_1449_: i32;
var phi_1576_: vec3<f32>;
var phi_1674_: i32;
var phi_1825_: type_21;
let _e51 = global;
let _e55 = arrayLength((&global_3.member));
let _e60 = global_2.member.member_2;
let _e63 = global_2.member.member;
let _e70 = (_e51.x + _e60.member);
let _e72 = (_e51.y + _e60.member_1);
if (_e70 < _e60.member_2) {
if (_e72 < _e60.member_3) {
let _e81 = global_2.member.member.member;
let _e83 = ((_e72 * _e81) + _e70);
let _e84 = (_e83 / 81u);
let _e86 = (_e83 - (_e84 * 81u));
let _e87 = (_e86 / 9u);
let _e91 = global_2.member.member_12.member_16;
let _e93 = bitcast<i32>((_e91 + _e84));
let _e95 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e97 = select(_e95, _e93, (_e93 < _e95));
let _e103 = global_5.member[bitcast<u32>(select(0i, _e97, (_e97 > 0i)))];
let _e113 = ((bitcast<i32>((_e103 & 65535u)) * 8i) + bitcast<i32>((_e86 - (_e87 * 9u))));
let _e116 = ((bitcast<i32>((_e103 >> bitcast<u32>(16i))) * 8i) + bitcast<i32>(_e87));
let _e118 = (_e63.member_2 == 5u);
if ((((_e63.member_2 == 1u) || _e118) || (_e63.member_2 == 6u)) || ((_e63.member_2 == 2u) || (_e63.member_2 == 7u))) {
let _e224 = global_2.member.member_12.member_4.member;
let _e225 = bitcast<i32>(_e224);
let _e230 = global_2.member.member_12.member_4.member_1;
let _e231 = bitcast<i32>(_e230);
let _e238 = ((((_e113 >= 0i) && (_e113 < _e225)) && (_e116 >= 0i)) && (_e116 < _e231));
if _e238 {
phi_276_ = ((_e116 * _e225) + _e113);
} else {
phi_276_ = 0i;
}
let _e242 = phi_276_;
let _e243 = (_e225 * _e231);
let _e245 = (bitcast<i32>(_e55) - 1i);
let _e247 = select(_e245, _e242, (_e242 < _e245));
let _e253 = global_3.member[bitcast<u32>(select(0i, _e247, (_e247 > 0i)))];
let _e256 = select(0f, 1f, (_e238 && (_e253 == 32f)));
let _e258 = ((3i * _e243) + _e242);
let _e260 = select(_e245, _e258, (_e258 < _e245));
let _e266 = global_3.member[bitcast<u32>(select(0i, _e260, (_e260 > 0i)))];
let _e268 = ((4i * _e243) + _e242);
let _e270 = select(_e245, _e268, (_e268 < _e245));
let _e276 = global_3.member[bitcast<u32>(select(0i, _e270, (_e270 > 0i)))];
let _e278 = ((5i * _e243) + _e242);
let _e280 = select(_e245, _e278, (_e278 < _e245));
let _e286 = global_3.member[bitcast<u32>(select(0i, _e280, (_e280 > 0i)))];
let _e288 = ((6i * _e243) + _e242);
let _e290 = select(_e245, _e288, (_e288 < _e245));
let _e296 = global_3.member[bitcast<u32>(select(0i, _e290, (_e290 > 0i)))];
let _e298 = ((7i * _e243) + _e242);
let _e300 = select(_e245, _e298, (_e298 < _e245));
let _e306 = global_3.member[bitcast<u32>(select(0i, _e300, (_e300 > 0i)))];
let _e315 = f32(_e113);
let _e316 = f32(_e116);
let _e320 = global_2.member.member_12.member_3;
let _e321 = (_e320 == 0u);
if _e321 {
phi_453_ = 1f;
} else {
let _e325 = global_2.member.member_12.member_5;
let _e329 = global_2.member.member_12.member_7;
let _e331 = (_e325 + (_e315 * _e329));
let _e335 = global_2.member.member_12.member_6;
let _e337 = (_e335 + (_e316 * _e329));
let _e342 = (((_e331 * _e331) + (_e337 * _e337)) + (1f * 1f));
let _e346 = (1f / sqrt(select(0f, _e342, (_e342 > 0f))));
phi_453_ = ((_e346 * _e346) * _e346);
}
let _e350 = phi_453_;
let _e351 = (_e315 + 1f);
if _e321 {
phi_487_ = 1f;
} else {
let _e355 = global_2.member.member_12.member_5;
let _e359 = global_2.member.member_12.member_7;
let _e361 = (_e355 + (_e351 * _e359));
let _e365 = global_2.member.member_12.member_6;
let _e367 = (_e365 + (_e316 * _e359));
let _e372 = (((_e361 * _e361) + (_e367 * _e367)) + (1f * 1f));
let _e376 = (1f / sqrt(select(0f, _e372, (_e372 > 0f))));
phi_487_ = ((_e376 * _e376) * _e376);
}
let _e380 = phi_487_;
let _e382 = (_e316 + 1f);
if _e321 {
phi_522_ = 1f;
} else {
let _e386 = global_2.member.member_12.member_5;
let _e390 = global_2.member.member_12.member_7;
let _e392 = (_e386 + (_e315 * _e390));
let _e396 = global_2.member.member_12.member_6;
let _e398 = (_e396 + (_e382 * _e390));
let _e403 = (((_e392 * _e392) + (_e398 * _e398)) + (1f * 1f));
let _e407 = (1f / sqrt(select(0f, _e403, (_e403 > 0f))));
phi_522_ = ((_e407 * _e407) * _e407);
}
let _e411 = phi_522_;
if _e321 {
phi_557_ = 1f;
} else {
let _e415 = global_2.member.member_12.member_5;
let _e419 = global_2.member.member_12.member_7;
let _e421 = (_e415 + (_e351 * _e419));
let _e425 = global_2.member.member_12.member_6;
let _e427 = (_e425 + (_e382 * _e419));
let _e432 = (((_e421 * _e421) + (_e427 * _e427)) + (1f * 1f));
let _e436 = (1f / sqrt(select(0f, _e432, (_e432 > 0f))));
phi_557_ = ((_e436 * _e436) * _e436);
}
let _e440 = phi_557_;
let _e443 = (((_e350 + _e380) + (_e411 + _e440)) * 0.25f);
if _e321 {
phi_667_ = 1f;
} else {
let _e449 = global_2.member.member_12.member_5;
let _e453 = global_2.member.member_12.member_7;
let _e455 = (_e449 + ((_e315 + 0.5f) * _e453));
let _e459 = global_2.member.member_12.member_6;
let _e461 = (_e459 + ((_e316 + 0.5f) * _e453));
let _e466 = global_2.member.member_12.member_20.member;
let _e474 = (((_e466.member * _e455) + (_e466.member_1 * _e461)) + (_e466.member_2 * 1f));
let _e478 = (_e455 - (_e466.member * _e474));
let _e479 = (_e461 - (_e466.member_1 * _e474));
let _e480 = (1f - (_e466.member_2 * _e474));
let _e485 = (((_e478 * _e478) + (_e479 * _e479)) + (_e480 * _e480));
let _e496 = global_2.member.member_12.member_20.member_1;
let _e502 = global_2.member.member_12.member_20.member_2;
let _e503 = ((_e496 - (sqrt(select(0f, _e485, (_e485 > 0f))) / select(1e-20f, _e474, (_e474 > 1e-20f)))) * _e502);
let _e505 = select(0f, _e503, (_e503 > 0f));
let _e507 = select(1f, _e505, (_e505 < 1f));
phi_667_ = select(1f, select(0f, ((_e507 * _e507) * (3f - (2f * _e507))), (_e474 > 0f)), (_e502 > 0f));
}
let _e517 = phi_667_;
let _e519 = select((_e443 * _e517), 1f, _e238);
let _e526 = global_2.member.member_12.member_15;
let _e527 = bitcast<i32>(_e526);
let _e529 = (firstTrailingBit(8u) & 31u);
let _e531 = (_e113 >> bitcast<u32>(_e529));
let _e533 = (_e116 >> bitcast<u32>(_e529));
let _e538 = global_2.member.member_12.member_14.member;
let _e539 = bitcast<i32>(_e538);
let _e544 = global_2.member.member_12.member_14.member_1;
let _e545 = bitcast<i32>(_e544);
let _e550 = global_2.member.member_12.member_14.member_2;
if ((((((_e531 >= 0i) && (_e531 < _e539)) && (_e533 >= 0i)) && (_e533 < _e545)) && (_e527 >= 0i)) && (_e527 < bitcast<i32>(_e550))) {
phi_721_ = (((((_e527 * _e545) + _e533) * _e539) + _e531) * 3i);
} else {
phi_721_ = -1i;
}
let _e569 = phi_721_;
let _e570 = (_e569 + 2i);
let _e572 = select(_e95, _e570, (_e570 < _e95));
let _e578 = global_5.member[bitcast<u32>(select(0i, _e572, (_e572 > 0i)))];
let _e579 = bitcast<i32>(_e578);
if ((_e569 < 0i) || (_e579 == 0i)) {
phi_765_ = -1i;
} else {
let _e594 = global_2.member.member_12.member_17.member;
let _e599 = global_2.member.member_12.member_17.member_1;
phi_765_ = (bitcast<i32>((_e594 * _e599)) + ((((_e579 - 1i) * 64i) + ((_e116 & 7i) * 8i)) + (_e113 & 7i)));
}
let _e604 = phi_765_;
let _e605 = (_e604 * 6i);
let _e607 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e609 = select(_e607, _e605, (_e605 < _e607));
let _e615 = global_4.member[bitcast<u32>(select(0i, _e609, (_e609 > 0i)))];
let _e616 = bitcast<i32>(_e615);
let _e617 = (_e605 + 1i);
let _e619 = select(_e607, _e617, (_e617 < _e607));
let _e625 = global_4.member[bitcast<u32>(select(0i, _e619, (_e619 > 0i)))];
let _e630 = f32(_e616);
let _e632 = (_e605 + 2i);
let _e634 = select(_e607, _e632, (_e632 < _e607));
let _e640 = global_4.member[bitcast<u32>(select(0i, _e634, (_e634 > 0i)))];
let _e641 = bitcast<i32>(_e640);
let _e642 = (_e605 + 3i);
let _e644 = select(_e607, _e642, (_e642 < _e607));
let _e650 = global_4.member[bitcast<u32>(select(0i, _e644, (_e644 > 0i)))];
let _e660 = (((_e63.member_2 == 3u) || (_e63.member_2 == 4u)) || _e118);
if _e660 {
phi_891_ = vec3(_e630);
} else {
let _e661 = (_e605 + 4i);
let _e663 = select(_e607, _e661, (_e661 < _e607));
let _e669 = global_4.member[bitcast<u32>(select(0i, _e663, (_e663 > 0i)))];
phi_891_ = vec3<f32>(_e630, f32((bitcast<i32>(_e625) - (_e616 >> bitcast<u32>(31i)))), f32(bitcast<i32>(_e669)));
}
let _e675 = phi_891_;
let _e677 = select(0f, 1f, (_e604 >= 0i));
let _e682 = (firstTrailingBit(4u) & 31u);
let _e684 = (_e113 >> bitcast<u32>(_e682));
let _e686 = (_e116 >> bitcast<u32>(_e682));
let _e691 = (1f / 4f);
let _e692 = (f32((_e113 - (_e684 << bitcast<u32>(_e682)))) * _e691);
let _e697 = (f32((_e116 - (_e686 << bitcast<u32>(_e682)))) * _e691);
let _e702 = global_2.member.member_12.member_17.member;
let _e703 = bitcast<i32>(_e702);
let _e708 = global_2.member.member_12.member_17.member_1;
let _e709 = bitcast<i32>(_e708);
let _e710 = (_e684 + 1i);
let _e711 = (_e686 + 1i);
let _e714 = ((_e710 >= 0i) && (_e710 < _e703));
let _e715 = (_e711 >= 0i);
let _e717 = (_e711 < _e709);
if ((_e714 && _e715) && _e717) {
phi_946_ = ((_e711 * _e703) + _e710);
} else {
phi_946_ = -1i;
}
let _e722 = phi_946_;
let _e723 = (1f - _e692);
let _e724 = (1f - _e697);
let _e726 = (_e722 * 6i);
let _e728 = select(_e607, _e726, (_e726 < _e607));
let _e734 = global_4.member[bitcast<u32>(select(0i, _e728, (_e728 > 0i)))];
let _e735 = bitcast<i32>(_e734);
let _e736 = (_e726 + 1i);
let _e738 = select(_e607, _e736, (_e736 < _e607));
let _e744 = global_4.member[bitcast<u32>(select(0i, _e738, (_e738 > 0i)))];
let _e749 = f32(_e735);
let _e751 = (_e726 + 2i);
let _e753 = select(_e607, _e751, (_e751 < _e607));
let _e759 = global_4.member[bitcast<u32>(select(0i, _e753, (_e753 > 0i)))];
let _e760 = bitcast<i32>(_e759);
let _e761 = (_e726 + 3i);
let _e763 = select(_e607, _e761, (_e761 < _e607));
let _e769 = global_4.member[bitcast<u32>(select(0i, _e763, (_e763 > 0i)))];
if _e660 {
phi_1075_ = vec3(_e749);
} else {
let _e776 = (_e726 + 4i);
let _e778 = select(_e607, _e776, (_e776 < _e607));
let _e784 = global_4.member[bitcast<u32>(select(0i, _e778, (_e778 > 0i)))];
phi_1075_ = vec3<f32>(_e749, f32((bitcast<i32>(_e744) - (_e735 >> bitcast<u32>(31i)))), f32(bitcast<i32>(_e784)));
}
let _e790 = phi_1075_;
let _e792 = select(0f, (_e723 * _e724), (_e722 >= 0i));
let _e796 = (_e684 + 2i);
let _e799 = ((_e796 >= 0i) && (_e796 < _e703));
if ((_e799 && _e715) && _e717) {
phi_1110_ = ((_e711 * _e703) + _e796);
} else {
phi_1110_ = -1i;
}
let _e805 = phi_1110_;
let _e807 = (_e805 * 6i);
let _e809 = select(_e607, _e807, (_e807 < _e607));
let _e815 = global_4.member[bitcast<u32>(select(0i, _e809, (_e809 > 0i)))];
let _e816 = bitcast<i32>(_e815);
let _e817 = (_e807 + 1i);
let _e819 = select(_e607, _e817, (_e817 < _e607));
let _e825 = global_4.member[bitcast<u32>(select(0i, _e819, (_e819 > 0i)))];
let _e830 = f32(_e816);
let _e832 = (_e807 + 2i);
let _e834 = select(_e607, _e832, (_e832 < _e607));
let _e840 = global_4.member[bitcast<u32>(select(0i, _e834, (_e834 > 0i)))];
let _e841 = bitcast<i32>(_e840);
let _e842 = (_e807 + 3i);
let _e844 = select(_e607, _e842, (_e842 < _e607));
let _e850 = global_4.member[bitcast<u32>(select(0i, _e844, (_e844 > 0i)))];
if _e660 {
phi_1238_ = vec3(_e830);
} else {
let _e857 = (_e807 + 4i);
let _e859 = select(_e607, _e857, (_e857 < _e607));
let _e865 = global_4.member[bitcast<u32>(select(0i, _e859, (_e859 > 0i)))];
phi_1238_ = vec3<f32>(_e830, f32((bitcast<i32>(_e825) - (_e816 >> bitcast<u32>(31i)))), f32(bitcast<i32>(_e865)));
}
let _e871 = phi_1238_;
let _e873 = select(0f, (_e692 * _e724), (_e805 >= 0i));
let _e880 = (_e686 + 2i);
let _e881 = (_e880 >= 0i);
let _e883 = (_e880 < _e709);
if ((_e714 && _e881) && _e883) {
phi_1285_ = ((_e880 * _e703) + _e710);
} else {
phi_1285_ = -1i;
}
let _e888 = phi_1285_;
let _e890 = (_e888 * 6i);
let _e892 = select(_e607, _e890, (_e890 < _e607));
let _e898 = global_4.member[bitcast<u32>(select(0i, _e892, (_e892 > 0i)))];
let _e899 = bitcast<i32>(_e898);
let _e900 = (_e890 + 1i);
let _e902 = select(_e607, _e900, (_e900 < _e607));
let _e908 = global_4.member[bitcast<u32>(select(0i, _e902, (_e902 > 0i)))];
let _e913 = f32(_e899);
let _e915 = (_e890 + 2i);
let _e917 = select(_e607, _e915, (_e915 < _e607));
let _e923 = global_4.member[bitcast<u32>(select(0i, _e917, (_e917 > 0i)))];
let _e924 = bitcast<i32>(_e923);
let _e925 = (_e890 + 3i);
let _e927 = select(_e607, _e925, (_e925 < _e607));
let _e933 = global_4.member[bitcast<u32>(select(0i, _e927, (_e927 > 0i)))];
if _e660 {
phi_1413_ = vec3(_e913);
} else {
let _e940 = (_e890 + 4i);
let _e942 = select(_e607, _e940, (_e940 < _e607));
let _e948 = global_4.member[bitcast<u32>(select(0i, _e942, (_e942 > 0i)))];
phi_1413_ = vec3<f32>(_e913, f32((bitcast<i32>(_e908) - (_e899 >> bitcast<u32>(31i)))), f32(bitcast<i32>(_e948)));
}
let _e954 = phi_1413_;
let _e956 = select(0f, (_e723 * _e697), (_e888 >= 0i));
if ((_e799 && _e881) && _e883) {
phi_1449_ = ((_e880 * _e703) + _e796);
} else {
phi_1449_ = -1i;
}
let _e965 = phi_1449_;
let _e967 = (_e965 * 6i);
let _e969 = select(_e607, _e967, (_e967 < _e607));
let _e975 = global_4.member[bitcast<u32>(select(0i, _e969, (_e969 > 0i)))];
let _e976 = bitcast<i32>(_e975);
let _e977 = (_e967 + 1i);
let _e979 = select(_e607, _e977, (_e977 < _e607));
let _e985 = global_4.member[bitcast<u32>(select(0i, _e979, (_e979 > 0i)))];
let _e990 = f32(_e976);
let _e992 = (_e967 + 2i);
let _e994 = select(_e607, _e992, (_e992 < _e607));
let _e1000 = global_4.member[bitcast<u32>(select(0i, _e994, (_e994 > 0i)))];
let _e1001 = bitcast<i32>(_e1000);
let _e1002 = (_e967 + 3i);
let _e1004 = select(_e607, _e1002, (_e1002 < _e607));
let _e1010 = global_4.member[bitcast<u32>(select(0i, _e1004, (_e1004 > 0i)))];
if _e660 {
phi_1576_ = vec3(_e990);
} else {
let _e1017 = (_e967 + 4i);
let _e1019 = select(_e607, _e1017, (_e1017 < _e607));
let _e1025 = global_4.member[bitcast<u32>(select(0i, _e1019, (_e1019 > 0i)))];
phi_1576_ = vec3<f32>(_e990, f32((bitcast<i32>(_e985) - (_e976 >> bitcast<u32>(31i)))), f32(bitcast<i32>(_e1025)));
}
let _e1031 = phi_1576_;
let _e1033 = select(0f, (_e692 * _e697), (_e965 >= 0i));
let _e1043 = ((_e675 * _e677) + (((_e790 * _e792) + (_e871 * _e873)) + ((_e954 * _e956) + (_e1031 * _e1033))));
let _e1049 = global_2.member.member_12.member_22;
let _e1050 = (1f / _e1049);
let _e1057 = ((select(1f, (_e266 * _e256), _e238) * _e519) + (_e1043.x * _e1050));
let _e1058 = ((select(1f, (_e276 * _e256), _e238) * _e519) + (_e1043.y * _e1050));
let _e1059 = ((select(1f, (_e286 * _e256), _e238) * _e519) + (_e1043.z * _e1050));
let _e1063 = (((_e1057 + _e1058) + _e1059) * (1f / 3f));
let _e1064 = (_e1063 > 1e-4f);
let _e1067 = select(0f, (1f / select(1e-4f, _e1063, _e1064)), _e1064);
let _e1070 = (((_e296 * _e256) + (((f32(_e641) * _e677) + (((f32(_e760) * _e792) + (f32(_e841) * _e873)) + ((f32(_e924) * _e956) + (f32(_e1001) * _e1033)))) * _e1050)) * _e1067);
let _e1073 = (((_e306 * _e256) + (((f32((bitcast<i32>(_e650) - (_e641 >> bitcast<u32>(31i)))) * _e677) + (((f32((bitcast<i32>(_e769) - (_e760 >> bitcast<u32>(31i)))) * _e792) + (f32((bitcast<i32>(_e850) - (_e841 >> bitcast<u32>(31i)))) * _e873)) + ((f32((bitcast<i32>(_e933) - (_e924 >> bitcast<u32>(31i)))) * _e956) + (f32((bitcast<i32>(_e1010) - (_e1001 >> bitcast<u32>(31i)))) * _e1033)))) * _e1050)) * _e1067);
let _e1074 = (1f / _e443);
if (_e1070 < 0f) {
let _e1106 = ((bitcast<f32>((bitcast<u32>(_e1070) & 2147483647u)) * 16255f) + 0.5f);
let _e1107 = (2f * 16255f);
let _e1109 = select(0f, _e1106, (_e1106 > 0f));
let _e1111 = select(_e1107, _e1109, (_e1109 < _e1107));
let _e1118 = select(0i, select(select(i32(_e1111), i32(-2147483648), (_e1111 < -2147483600f)), 2147483647i, (_e1111 > 2147483500f)), (_e1111 == _e1111));
phi_1674_ = (32768i - (_e1118 - select(0i, 1i, (_e1111 < f32(_e1118)))));
} else {
let _e1084 = ((bitcast<f32>((bitcast<u32>(_e1070) & 2147483647u)) * 16255f) + 0.5f);
let _e1085 = (2f * 16255f);
let _e1087 = select(0f, _e1084, (_e1084 > 0f));
let _e1089 = select(_e1085, _e1087, (_e1087 < _e1085));
let _e1096 = select(0i, select(select(i32(_e1089), i32(-2147483648), (_e1089 < -2147483600f)), 2147483647i, (_e1089 > 2147483500f)), (_e1089 == _e1089));
phi_1674_ = (32768i + (_e1096 - select(0i, 1i, (_e1089 < f32(_e1096)))));
}
let _e1125 = phi_1674_;
let _e1130 = ((bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u)) * 16255f) + 0.5f);
let _e1131 = (2f * 16255f);
let _e1133 = select(0f, _e1130, (_e1130 > 0f));
let _e1135 = select(_e1131, _e1133, (_e1133 < _e1131));
let _e1142 = select(0i, select(select(i32(_e1135), i32(-2147483648), (_e1135 < -2147483600f)), 2147483647i, (_e1135 > 2147483500f)), (_e1135 == _e1135));
let _e1146 = (_e1142 - select(0i, 1i, (_e1135 < f32(_e1142))));
phi_1825_ = type_21(vec3<f32>((_e1057 * _e1074), (_e1058 * _e1074), (_e1059 * _e1074)), bitcast<f32>(((select(0u, 2147483648u, ((_e1073 < 0f) && (_e1146 > 0i))) | (bitcast<u32>((_e1146 + 128i)) << bitcast<u32>(16i))) | bitcast<u32>(_e1125))));
} else {
let _e131 = global_2.member.member_12.member_4.member;
let _e141 = global_2.member.member_12.member_4.member_1;
let _e144 = ((((_e113 >= 0i) && (_e113 <= bitcast<i32>(_e131))) && (_e116 >= 0i)) && (_e116 <= bitcast<i32>(_e141)));
if _e144 {
phi_1714_ = bitcast<u32>(_e116);
phi_1715_ = bitcast<u32>(_e113);
} else {
phi_1714_ = 0u;
phi_1715_ = 0u;
}
let _e148 = phi_1714_;
let _e150 = phi_1715_;
let _e151 = (_e131 + 1u);
let _e154 = bitcast<i32>((_e151 * (_e141 + 1u)));
let _e159 = ((6i * _e154) + bitcast<i32>(((_e148 * _e151) + _e150)));
let _e161 = (bitcast<i32>(_e55) - 1i);
let _e163 = select(_e161, _e159, (_e159 < _e161));
let _e169 = global_3.member[bitcast<u32>(select(0i, _e163, (_e163 > 0i)))];
let _e170 = (_e159 + _e154);
let _e172 = select(_e161, _e170, (_e170 < _e161));
let _e178 = global_3.member[bitcast<u32>(select(0i, _e172, (_e172 > 0i)))];
let _e180 = (_e159 + (2i * _e154));
let _e182 = select(_e161, _e180, (_e180 < _e161));
let _e188 = global_3.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e194 = ((0f * 16255f) + 0.5f);
let _e195 = (2f * 16255f);
let _e197 = select(0f, _e194, (_e194 > 0f));
let _e199 = select(_e195, _e197, (_e197 < _e195));
let _e206 = select(0i, select(select(i32(_e199), i32(-2147483648), (_e199 < -2147483600f)), 2147483647i, (_e199 > 2147483500f)), (_e199 == _e199));
let _e210 = (_e206 - select(0i, 1i, (_e199 < f32(_e206))));
phi_1825_ = type_21(vec3<f32>(select(1f, _e169, _e144), select(1f, _e178, _e144), select(1f, _e188, _e144)), bitcast<f32>(((bitcast<u32>((_e210 + 128i)) << bitcast<u32>(16i)) | bitcast<u32>((32768i + _e210)))));
}
let _e1161 = phi_1825_;
global_1.member[((_e72 * _e63.member) + _e70)] = _e1161.member.x;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
