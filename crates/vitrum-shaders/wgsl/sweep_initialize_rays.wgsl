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
struct type_11 {
member: array<f32>,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_19 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_20 {
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
struct type_21 {
member: type_5,
member_1: type_5,
}
struct type_22 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_23 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_24 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
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
member_17: type_14,
member_18: type_22,
member_19: type_5,
member_20: type_23,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_25 {
member: type_7,
member_1: u32,
}
struct type_26 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_14,
member_4: u32,
member_5: type_18,
member_6: type_19,
member_7: type_19,
member_8: type_20,
member_9: type_21,
member_10: type_24,
member_11: type_18,
member_12: type_4,
member_13: type_9,
member_14: type_25,
member_15: type_25,
member_16: type_25,
member_17: type_25,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_27 {
member: type_26,
}
struct type_28 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_27;
@group(0) @binding(2)
var<storage, read_write> global_2: type_11;
@group(0) @binding(1)
var<storage> global_3: type_16;
fn function_() {
var phi_191_: type_14;
var phi_791_: u32;
var phi_1128_: f32;
var phi_1184_: f32;
var phi_1189_: vec3<f32>;
var phi_1292_: f32;
var phi_1376_: f32;
var phi_1448_: type_28;
var phi_1449_: type_28;
let _e39 = global;
let _e44 = global_1.member.member_2;
let _e47 = global_1.member.member;
let _e55 = (_e39.x + _e44.member);
let _e57 = (_e39.y + _e44.member_1);
if (_e55 < _e44.member_2) {
if (_e57 < _e44.member_3) {
let _e60 = (_e47.member * _e47.member_1);
let _e62 = ((_e57 * _e47.member) + _e55);
let _e66 = global_1.member.member_3.member;
let _e70 = global_1.member.member_3.member_1;
let _e71 = (_e55 % 16u);
let _e72 = (_e57 % 4u);
if ((_e55 < (_e66 - (_e66 % 16u))) && (_e57 < (_e70 - (_e70 % 4u)))) {
phi_191_ = type_14((((_e55 - _e71) + (_e72 * 4u)) + (_e71 % 4u)), ((_e57 - _e72) + (_e71 / 4u)));
} else {
phi_191_ = type_14(_e55, _e57);
}
let _e91 = phi_191_;
let _e105 = global_1.member.member_12.member;
let _e106 = (((((f32(bitcast<i32>(_e91.member)) + 0.5f) / f32(bitcast<i32>(_e66))) * 2f) - 1f) * _e105);
let _e118 = global_1.member.member_12.member_1;
let _e119 = ((1f - (((f32(bitcast<i32>(_e91.member_1)) + 0.5f) / f32(bitcast<i32>(_e70))) * 2f)) * _e118);
let _e123 = global_1.member.member_12.member_3;
let _e124 = (_e123 != 0u);
let _e128 = global_1.member.member_12.member_2;
let _e129 = select(_e106, 0f, _e124);
let _e130 = select(_e119, 0f, _e124);
let _e131 = select(0f, _e106, _e124);
let _e132 = select(0f, _e119, _e124);
let _e136 = (_e131 + (_e129 * _e128));
let _e137 = (_e132 + (_e130 * _e128));
let _e138 = (0f + (1f * _e128));
let _e143 = (((_e129 * _e129) + (_e130 * _e130)) + (1f * 1f));
let _e146 = sqrt(select(0f, _e143, (_e143 > 0f)));
let _e149 = (1f / select(1e-20f, _e146, (_e146 > 1e-20f)));
let _e157 = global_1.member.member_13.member.member;
let _e168 = ((((_e157.member.member * _e131) + (_e157.member.member_1 * _e132)) + (_e157.member.member_2 * 0f)) + _e157.member_1);
let _e174 = ((((_e157.member.member * _e136) + (_e157.member.member_1 * _e137)) + (_e157.member.member_2 * _e138)) + _e157.member_1);
let _e177 = ((_e168 > 0f) && (_e174 <= 0f));
let _e178 = (_e168 - _e174);
let _e181 = (_e168 / select(1e-20f, _e178, (_e178 > 1e-20f)));
let _e186 = global_1.member.member_13.member_1.member;
let _e197 = ((((_e186.member.member * _e131) + (_e186.member.member_1 * _e132)) + (_e186.member.member_2 * 0f)) + _e186.member_1);
let _e203 = ((((_e186.member.member * _e136) + (_e186.member.member_1 * _e137)) + (_e186.member.member_2 * _e138)) + _e186.member_1);
let _e206 = ((_e197 > 0f) && (_e203 <= 0f));
let _e207 = (_e197 - _e203);
let _e210 = (_e197 / select(1e-20f, _e207, (_e207 > 1e-20f)));
let _e214 = (_e206 && (!(_e177) || (_e210 < _e181)));
let _e220 = global_1.member.member_13.member_1.member.member;
let _e225 = global_1.member.member_13.member_1.member_1;
let _e231 = global_1.member.member_13.member.member.member;
let _e236 = global_1.member.member_13.member.member_1;
let _e255 = (_e177 || _e206);
let _e256 = select(_e181, _e210, _e214);
let _e261 = select(1f, _e256, (_e256 < 1f));
let _e265 = (_e131 + ((_e136 - _e131) * _e261));
let _e266 = (_e132 + ((_e137 - _e132) * _e261));
let _e267 = (0f + ((_e138 - 0f) * _e261));
let _e271 = global_1.member.member_10.member;
let _e282 = ((((_e271.member.member * _e265) + (_e271.member.member_1 * _e266)) + (_e271.member.member_2 * _e267)) + _e271.member_1);
let _e286 = global_1.member.member_10.member_1;
let _e297 = ((((_e286.member.member * _e265) + (_e286.member.member_1 * _e266)) + (_e286.member.member_2 * _e267)) + _e286.member_1);
let _e301 = global_1.member.member_10.member_2;
let _e312 = ((((_e301.member.member * _e265) + (_e301.member.member_1 * _e266)) + (_e301.member.member_2 * _e267)) + _e301.member_1);
let _e316 = global_1.member.member_10.member_3;
let _e317 = (_e316 != 0u);
let _e321 = global_1.member.member_10.member_19;
let _e325 = (_e282 - _e321.member);
let _e326 = (_e297 - _e321.member_1);
let _e327 = (_e312 - _e321.member_2);
let _e332 = (((_e325 * _e325) + (_e326 * _e326)) + (_e327 * _e327));
let _e335 = sqrt(select(0f, _e332, (_e332 > 0f)));
let _e338 = (1f / select(1e-20f, _e335, (_e335 > 1e-20f)));
let _e342 = select(0f, (_e325 * _e338), _e317);
let _e343 = select(0f, (_e326 * _e338), _e317);
let _e344 = select(1f, (_e327 * _e338), _e317);
let _e349 = global_1.member.member_10.member.member;
let _e360 = global_1.member.member_10.member_1.member;
let _e374 = global_1.member.member_10.member_2.member;
let _e383 = (vec3<f32>(((_e349.member * _e342) + (_e360.member * _e343)), ((_e349.member_1 * _e342) + (_e360.member_1 * _e343)), ((_e349.member_2 * _e342) + (_e360.member_2 * _e343))) + vec3<f32>((_e374.member * _e344), (_e374.member_1 * _e344), (_e374.member_2 * _e344)));
let _e386 = global_1.member.member_1;
if ((_e386 & 256u) != 0u) {
let _e394 = global_1.member.member_10.member_18.member.member;
let _e395 = bitcast<i32>(_e394);
let _e401 = global_1.member.member_10.member_18.member.member_1;
let _e402 = bitcast<i32>(_e401);
let _e407 = global_1.member.member_10.member_19.member_2;
let _e409 = select(1f, (_e312 - _e407), _e317);
let _e412 = (1f / select(1e-12f, _e409, (_e409 > 1e-12f)));
let _e417 = global_1.member.member_10.member_5;
let _e422 = global_1.member.member_10.member_8;
let _e423 = (((_e282 * _e412) - _e417) * _e422);
let _e428 = global_1.member.member_10.member_6;
let _e430 = (((_e297 * _e412) - _e428) * _e422);
let _e435 = global_1.member.member_10.member_4.member;
let _e437 = f32(bitcast<i32>(_e435));
let _e439 = select(0f, _e423, (_e423 > 0f));
let _e446 = global_1.member.member_10.member_18.member_1;
let _e449 = ((_e423 - _e437) * _e446);
let _e454 = global_1.member.member_10.member_18.member_2;
let _e456 = select(0f, _e449, (_e449 > 0f));
let _e458 = (_e454 + _e456);
let _e463 = (-(_e423) * _e446);
let _e465 = select(0f, _e463, (_e463 > 0f));
let _e467 = (_e454 + _e465);
let _e474 = (((_e454 + (select(_e437, _e439, (_e439 < _e437)) * _e446)) + (((_e456 * _e454) / select(1e-12f, _e458, (_e458 > 1e-12f))) - ((_e465 * _e454) / select(1e-12f, _e467, (_e467 > 1e-12f))))) - 0.5f);
let _e479 = global_1.member.member_10.member_4.member_1;
let _e481 = f32(bitcast<i32>(_e479));
let _e483 = select(0f, _e430, (_e430 > 0f));
let _e488 = ((_e430 - _e481) * _e446);
let _e490 = select(0f, _e488, (_e488 > 0f));
let _e492 = (_e454 + _e490);
let _e497 = (-(_e430) * _e446);
let _e499 = select(0f, _e497, (_e497 > 0f));
let _e501 = (_e454 + _e499);
let _e508 = (((_e454 + (select(_e481, _e483, (_e483 < _e481)) * _e446)) + (((_e490 * _e454) / select(1e-12f, _e492, (_e492 > 1e-12f))) - ((_e499 * _e454) / select(1e-12f, _e501, (_e501 > 1e-12f))))) - 0.5f);
let _e510 = f32((_e395 - 2i));
let _e512 = select(0f, _e474, (_e474 > 0f));
let _e514 = select(_e510, _e512, (_e512 < _e510));
let _e521 = select(0i, select(select(i32(_e514), i32(-2147483648), (_e514 < -2147483600f)), 2147483647i, (_e514 > 2147483500f)), (_e514 == _e514));
let _e525 = (_e521 - select(0i, 1i, (_e514 < f32(_e521))));
let _e527 = f32((_e402 - 2i));
let _e529 = select(0f, _e508, (_e508 > 0f));
let _e531 = select(_e527, _e529, (_e529 < _e527));
let _e538 = select(0i, select(select(i32(_e531), i32(-2147483648), (_e531 < -2147483600f)), 2147483647i, (_e531 > 2147483500f)), (_e531 == _e531));
let _e542 = (_e538 - select(0i, 1i, (_e531 < f32(_e538))));
let _e544 = (_e474 - f32(_e525));
let _e546 = select(0f, _e544, (_e544 > 0f));
let _e548 = select(1f, _e546, (_e546 < 1f));
let _e550 = (_e508 - f32(_e542));
let _e552 = select(0f, _e550, (_e550 > 0f));
let _e554 = select(1f, _e552, (_e552 < 1f));
if _e214 {
let _e559 = global_1.member.member_10.member_18.member_4;
phi_791_ = _e559;
} else {
let _e564 = global_1.member.member_10.member_18.member_3;
phi_791_ = _e564;
}
let _e566 = phi_791_;
let _e570 = ((bitcast<i32>(_e566) + (_e542 * _e395)) + _e525);
let _e571 = (_e395 * _e402);
let _e573 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e575 = select(_e573, _e570, (_e570 < _e573));
let _e581 = global_3.member[bitcast<u32>(select(0i, _e575, (_e575 > 0i)))];
let _e582 = bitcast<f32>(_e581);
let _e583 = (_e570 + 1i);
let _e585 = select(_e573, _e583, (_e583 < _e573));
let _e591 = global_3.member[bitcast<u32>(select(0i, _e585, (_e585 > 0i)))];
let _e595 = (_e582 + ((bitcast<f32>(_e591) - _e582) * _e548));
let _e596 = (_e570 + _e395);
let _e598 = select(_e573, _e596, (_e596 < _e573));
let _e604 = global_3.member[bitcast<u32>(select(0i, _e598, (_e598 > 0i)))];
let _e605 = bitcast<f32>(_e604);
let _e606 = (_e596 + 1i);
let _e608 = select(_e573, _e606, (_e606 < _e573));
let _e614 = global_3.member[bitcast<u32>(select(0i, _e608, (_e608 > 0i)))];
let _e621 = (_e595 + (((_e605 + ((bitcast<f32>(_e614) - _e605) * _e548)) - _e595) * _e554));
let _e622 = (_e570 + _e571);
let _e624 = select(_e573, _e622, (_e622 < _e573));
let _e630 = global_3.member[bitcast<u32>(select(0i, _e624, (_e624 > 0i)))];
let _e631 = bitcast<f32>(_e630);
let _e632 = (_e622 + 1i);
let _e634 = select(_e573, _e632, (_e632 < _e573));
let _e640 = global_3.member[bitcast<u32>(select(0i, _e634, (_e634 > 0i)))];
let _e644 = (_e631 + ((bitcast<f32>(_e640) - _e631) * _e548));
let _e645 = (_e622 + _e395);
let _e647 = select(_e573, _e645, (_e645 < _e573));
let _e653 = global_3.member[bitcast<u32>(select(0i, _e647, (_e647 > 0i)))];
let _e654 = bitcast<f32>(_e653);
let _e655 = (_e645 + 1i);
let _e657 = select(_e573, _e655, (_e655 < _e573));
let _e663 = global_3.member[bitcast<u32>(select(0i, _e657, (_e657 > 0i)))];
let _e670 = (_e644 + (((_e654 + ((bitcast<f32>(_e663) - _e654) * _e548)) - _e644) * _e554));
let _e672 = (_e570 + (2i * _e571));
let _e674 = select(_e573, _e672, (_e672 < _e573));
let _e680 = global_3.member[bitcast<u32>(select(0i, _e674, (_e674 > 0i)))];
let _e681 = bitcast<f32>(_e680);
let _e682 = (_e672 + 1i);
let _e684 = select(_e573, _e682, (_e682 < _e573));
let _e690 = global_3.member[bitcast<u32>(select(0i, _e684, (_e684 > 0i)))];
let _e694 = (_e681 + ((bitcast<f32>(_e690) - _e681) * _e548));
let _e695 = (_e672 + _e395);
let _e697 = select(_e573, _e695, (_e695 < _e573));
let _e703 = global_3.member[bitcast<u32>(select(0i, _e697, (_e697 > 0i)))];
let _e704 = bitcast<f32>(_e703);
let _e705 = (_e695 + 1i);
let _e707 = select(_e573, _e705, (_e705 < _e573));
let _e713 = global_3.member[bitcast<u32>(select(0i, _e707, (_e707 > 0i)))];
let _e720 = (_e694 + (((_e704 + ((bitcast<f32>(_e713) - _e704) * _e548)) - _e694) * _e554));
let _e722 = (_e316 == 0u);
if _e722 {
phi_1189_ = vec3<f32>(_e621, _e670, _e720);
} else {
if _e722 {
phi_1128_ = 1f;
} else {
let _e727 = global_1.member.member_10.member_20.member;
let _e735 = (((_e727.member * _e325) + (_e727.member_1 * _e326)) + (_e727.member_2 * _e327));
let _e739 = (_e325 - (_e727.member * _e735));
let _e740 = (_e326 - (_e727.member_1 * _e735));
let _e741 = (_e327 - (_e727.member_2 * _e735));
let _e746 = (((_e739 * _e739) + (_e740 * _e740)) + (_e741 * _e741));
let _e757 = global_1.member.member_10.member_20.member_1;
let _e763 = global_1.member.member_10.member_20.member_2;
let _e764 = ((_e757 - (sqrt(select(0f, _e746, (_e746 > 0f))) / select(1e-20f, _e735, (_e735 > 1e-20f)))) * _e763);
let _e766 = select(0f, _e764, (_e764 > 0f));
let _e768 = select(1f, _e766, (_e766 < 1f));
phi_1128_ = select(1f, select(0f, ((_e768 * _e768) * (3f - (2f * _e768))), (_e735 > 0f)), (_e763 > 0f));
}
let _e778 = phi_1128_;
let _e780 = select(0f, 1f, (_e327 > 0f));
let _e784 = ((_e621 * _e780) + _e778);
let _e785 = ((_e670 * _e780) + _e778);
let _e786 = ((_e720 * _e780) + _e778);
if _e722 {
phi_1184_ = 1f;
} else {
phi_1184_ = (1f / select(1e-12f, _e332, (_e332 > 1e-12f)));
}
let _e797 = phi_1184_;
phi_1189_ = vec3<f32>((select(0f, _e784, (_e784 > 0f)) * _e797), (select(0f, _e785, (_e785 > 0f)) * _e797), (select(0f, _e786, (_e786 > 0f)) * _e797));
}
let _e803 = phi_1189_;
let _e807 = global_1.member.member_9.member_1;
phi_1449_ = type_28((vec3<f32>(_e807.member, _e807.member_1, _e807.member_2) * _e803), _e383);
} else {
let _e814 = (_e316 == 0u);
if _e814 {
let _e818 = global_1.member.member_9.member_1;
let _e826 = global_1.member.member_9.member;
phi_1448_ = type_28(vec3<f32>(_e818.member, _e818.member_1, _e818.member_2), vec3<f32>(_e826.member, _e826.member_1, _e826.member_2));
} else {
let _e835 = global_1.member.member_9.member_1;
if _e814 {
phi_1292_ = 1f;
} else {
phi_1292_ = (1f / select(1e-12f, _e332, (_e332 > 1e-12f)));
}
let _e843 = phi_1292_;
if _e814 {
phi_1376_ = 1f;
} else {
let _e848 = global_1.member.member_10.member_20.member;
let _e856 = (((_e848.member * _e325) + (_e848.member_1 * _e326)) + (_e848.member_2 * _e327));
let _e860 = (_e325 - (_e848.member * _e856));
let _e861 = (_e326 - (_e848.member_1 * _e856));
let _e862 = (_e327 - (_e848.member_2 * _e856));
let _e867 = (((_e860 * _e860) + (_e861 * _e861)) + (_e862 * _e862));
let _e878 = global_1.member.member_10.member_20.member_1;
let _e884 = global_1.member.member_10.member_20.member_2;
let _e885 = ((_e878 - (sqrt(select(0f, _e867, (_e867 > 0f))) / select(1e-20f, _e856, (_e856 > 1e-20f)))) * _e884);
let _e887 = select(0f, _e885, (_e885 > 0f));
let _e889 = select(1f, _e887, (_e887 < 1f));
phi_1376_ = select(1f, select(0f, ((_e889 * _e889) * (3f - (2f * _e889))), (_e856 > 0f)), (_e884 > 0f));
}
let _e899 = phi_1376_;
let _e900 = (_e843 * _e899);
phi_1448_ = type_28(vec3<f32>((_e835.member * _e900), (_e835.member_1 * _e900), (_e835.member_2 * _e900)), _e383);
}
let _e907 = phi_1448_;
phi_1449_ = _e907;
}
let _e909 = phi_1449_;
let _e918 = (((_e909.member_1.x * _e909.member_1.x) + (_e909.member_1.y * _e909.member_1.y)) + (_e909.member_1.z * _e909.member_1.z));
let _e921 = sqrt(select(0f, _e918, (_e918 > 0f)));
let _e927 = (1e-6f * _e921);
let _e931 = select((_e921 / select(_e927, _e909.member_1.z, (_e909.member_1.z > _e927))), 1f, ((_e386 & 8u) != 0u));
let _e940 = global_1.member.member_18;
let _e952 = (-((((select(_e231.member, _e220.member, _e214) * _e909.member_1.x) + (select(_e231.member_1, _e220.member_1, _e214) * _e909.member_1.y)) + (select(_e231.member_2, _e220.member_2, _e214) * _e909.member_1.z))) / select(1e-20f, _e921, (_e921 > 1e-20f)));
let _e957 = bitcast<f32>((bitcast<u32>(select(0f, _e952, (_e952 > 0f))) & 2147483647u));
let _e967 = select(0f, 1f, _e255);
global_2.member[_e62] = _e136;
global_2.member[(_e60 + _e62)] = _e137;
global_2.member[((2u * _e60) + _e62)] = _e138;
global_2.member[((3u * _e60) + _e62)] = (_e129 * _e149);
global_2.member[((4u * _e60) + _e62)] = (_e130 * _e149);
global_2.member[((5u * _e60) + _e62)] = (1f * _e149);
global_2.member[((6u * _e60) + _e62)] = 0f;
global_2.member[((7u * _e60) + _e62)] = _e967;
global_2.member[((8u * _e60) + _e62)] = select(0f, (_e256 * _e128), _e255);
global_2.member[((9u * _e60) + _e62)] = select(0f, (select(_e236.member, _e225.member, _e214) * (((_e909.member.x * _e931) * _e957) + _e940.member)), _e255);
global_2.member[((10u * _e60) + _e62)] = select(0f, (select(_e236.member_1, _e225.member_1, _e214) * (((_e909.member.y * _e931) * _e957) + _e940.member_1)), _e255);
global_2.member[((11u * _e60) + _e62)] = select(0f, (select(_e236.member_2, _e225.member_2, _e214) * (((_e909.member.z * _e931) * _e957) + _e940.member_2)), _e255);
global_2.member[((12u * _e60) + _e62)] = _e967;
global_2.member[((13u * _e60) + _e62)] = 1f;
global_2.member[((14u * _e60) + _e62)] = 1f;
global_2.member[((15u * _e60) + _e62)] = 1f;
global_2.member[((16u * _e60) + _e62)] = 0f;
global_2.member[((17u * _e60) + _e62)] = -1.2676506e30f;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
