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
member_4: type_14,
member_5: u32,
member_6: u32,
member_7: type_18,
member_8: type_19,
member_9: type_19,
member_10: type_20,
member_11: type_21,
member_12: type_24,
member_13: type_18,
member_14: type_4,
member_15: type_9,
member_16: type_25,
member_17: type_25,
member_18: type_25,
member_19: type_25,
member_20: type_5,
member_21: f32,
member_22: f32,
member_23: type_6,
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
@group(0) @binding(3)
var<storage, read_write> global_2: type_11;
@group(0) @binding(1)
var<storage> global_3: type_16;
@group(0) @binding(2)
var<storage> global_4: type_16;
fn function_() {
var phi_196_: type_14;
var phi_265_: type_14;
var phi_865_: u32;
var phi_1202_: f32;
var phi_1258_: f32;
var phi_1263_: vec3<f32>;
var phi_1366_: f32;
var phi_1450_: f32;
var phi_1522_: type_28;
var phi_1523_: type_28;
switch bitcast<i32>(0u) {
default: {
let _e43 = global;
let _e50 = global_1.member.member_2;
let _e53 = global_1.member.member;
let _e61 = (_e43.x + _e50.member);
let _e63 = (_e43.y + _e50.member_1);
if (_e61 < _e50.member_2) {
if (_e63 < _e50.member_3) {
let _e66 = (_e53.member * _e53.member_1);
let _e68 = ((_e63 * _e53.member) + _e61);
let _e72 = global_1.member.member_3.member;
let _e76 = global_1.member.member_3.member_1;
let _e77 = (_e61 % 16u);
let _e78 = (_e63 % 4u);
if ((_e61 < (_e72 - (_e72 % 16u))) && (_e63 < (_e76 - (_e76 % 4u)))) {
phi_196_ = type_14((((_e61 - _e77) + (_e78 * 4u)) + (_e77 % 4u)), ((_e63 - _e78) + (_e77 / 4u)));
} else {
phi_196_ = type_14(_e61, _e63);
}
let _e97 = phi_196_;
let _e102 = global_1.member.member_5;
let _e103 = (_e102 == 0u);
let _e104 = select(_e102, 1u, _e103);
let _e105 = (_e104 == 0u);
if _e105 {
break;
}
if _e105 {
break;
}
if _e105 {
break;
}
let _e111 = bitcast<i32>((((_e97.member_1 / _e104) * (_e72 / _e104)) + (_e97.member / _e104)));
let _e113 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e115 = select(_e113, _e111, (_e111 < _e113));
let _e121 = global_4.member[bitcast<u32>(select(0i, _e115, (_e115 > 0i)))];
if _e103 {
phi_265_ = _e97;
} else {
if _e105 {
break;
}
if _e105 {
break;
}
phi_265_ = type_14((((_e121 & 65535u) * _e104) + (_e97.member % _e104)), (((_e121 >> bitcast<u32>(16u)) * _e104) + (_e97.member_1 % _e104)));
}
let _e133 = phi_265_;
let _e142 = global_1.member.member_4.member;
let _e151 = global_1.member.member_14.member;
let _e152 = (((((f32(bitcast<i32>(_e133.member)) + 0.5f) / f32(bitcast<i32>(_e142))) * 2f) - 1f) * _e151);
let _e159 = global_1.member.member_4.member_1;
let _e168 = global_1.member.member_14.member_1;
let _e169 = ((1f - (((f32(bitcast<i32>(_e133.member_1)) + 0.5f) / f32(bitcast<i32>(_e159))) * 2f)) * _e168);
let _e173 = global_1.member.member_14.member_3;
let _e174 = (_e173 != 0u);
let _e178 = global_1.member.member_14.member_2;
let _e179 = select(_e152, 0f, _e174);
let _e180 = select(_e169, 0f, _e174);
let _e181 = select(0f, _e152, _e174);
let _e182 = select(0f, _e169, _e174);
let _e186 = (_e181 + (_e179 * _e178));
let _e187 = (_e182 + (_e180 * _e178));
let _e188 = (0f + (1f * _e178));
let _e193 = (((_e179 * _e179) + (_e180 * _e180)) + (1f * 1f));
let _e196 = sqrt(select(0f, _e193, (_e193 > 0f)));
let _e199 = (1f / select(1e-20f, _e196, (_e196 > 1e-20f)));
let _e207 = global_1.member.member_15.member.member;
let _e218 = ((((_e207.member.member * _e181) + (_e207.member.member_1 * _e182)) + (_e207.member.member_2 * 0f)) + _e207.member_1);
let _e224 = ((((_e207.member.member * _e186) + (_e207.member.member_1 * _e187)) + (_e207.member.member_2 * _e188)) + _e207.member_1);
let _e227 = ((_e218 > 0f) && (_e224 <= 0f));
let _e228 = (_e218 - _e224);
let _e231 = (_e218 / select(1e-20f, _e228, (_e228 > 1e-20f)));
let _e236 = global_1.member.member_15.member_1.member;
let _e247 = ((((_e236.member.member * _e181) + (_e236.member.member_1 * _e182)) + (_e236.member.member_2 * 0f)) + _e236.member_1);
let _e253 = ((((_e236.member.member * _e186) + (_e236.member.member_1 * _e187)) + (_e236.member.member_2 * _e188)) + _e236.member_1);
let _e256 = ((_e247 > 0f) && (_e253 <= 0f));
let _e257 = (_e247 - _e253);
let _e260 = (_e247 / select(1e-20f, _e257, (_e257 > 1e-20f)));
let _e264 = (_e256 && (!(_e227) || (_e260 < _e231)));
let _e270 = global_1.member.member_15.member_1.member.member;
let _e275 = global_1.member.member_15.member_1.member_1;
let _e281 = global_1.member.member_15.member.member.member;
let _e286 = global_1.member.member_15.member.member_1;
let _e305 = (_e227 || _e256);
let _e306 = select(_e231, _e260, _e264);
let _e311 = select(1f, _e306, (_e306 < 1f));
let _e315 = (_e181 + ((_e186 - _e181) * _e311));
let _e316 = (_e182 + ((_e187 - _e182) * _e311));
let _e317 = (0f + ((_e188 - 0f) * _e311));
let _e321 = global_1.member.member_12.member;
let _e332 = ((((_e321.member.member * _e315) + (_e321.member.member_1 * _e316)) + (_e321.member.member_2 * _e317)) + _e321.member_1);
let _e336 = global_1.member.member_12.member_1;
let _e347 = ((((_e336.member.member * _e315) + (_e336.member.member_1 * _e316)) + (_e336.member.member_2 * _e317)) + _e336.member_1);
let _e351 = global_1.member.member_12.member_2;
let _e362 = ((((_e351.member.member * _e315) + (_e351.member.member_1 * _e316)) + (_e351.member.member_2 * _e317)) + _e351.member_1);
let _e366 = global_1.member.member_12.member_3;
let _e367 = (_e366 != 0u);
let _e371 = global_1.member.member_12.member_19;
let _e375 = (_e332 - _e371.member);
let _e376 = (_e347 - _e371.member_1);
let _e377 = (_e362 - _e371.member_2);
let _e382 = (((_e375 * _e375) + (_e376 * _e376)) + (_e377 * _e377));
let _e385 = sqrt(select(0f, _e382, (_e382 > 0f)));
let _e388 = (1f / select(1e-20f, _e385, (_e385 > 1e-20f)));
let _e392 = select(0f, (_e375 * _e388), _e367);
let _e393 = select(0f, (_e376 * _e388), _e367);
let _e394 = select(1f, (_e377 * _e388), _e367);
let _e399 = global_1.member.member_12.member.member;
let _e410 = global_1.member.member_12.member_1.member;
let _e424 = global_1.member.member_12.member_2.member;
let _e433 = (vec3<f32>(((_e399.member * _e392) + (_e410.member * _e393)), ((_e399.member_1 * _e392) + (_e410.member_1 * _e393)), ((_e399.member_2 * _e392) + (_e410.member_2 * _e393))) + vec3<f32>((_e424.member * _e394), (_e424.member_1 * _e394), (_e424.member_2 * _e394)));
let _e436 = global_1.member.member_1;
if ((_e436 & 256u) != 0u) {
let _e444 = global_1.member.member_12.member_18.member.member;
let _e445 = bitcast<i32>(_e444);
let _e451 = global_1.member.member_12.member_18.member.member_1;
let _e452 = bitcast<i32>(_e451);
let _e457 = global_1.member.member_12.member_19.member_2;
let _e459 = select(1f, (_e362 - _e457), _e367);
let _e462 = (1f / select(1e-12f, _e459, (_e459 > 1e-12f)));
let _e467 = global_1.member.member_12.member_5;
let _e472 = global_1.member.member_12.member_8;
let _e473 = (((_e332 * _e462) - _e467) * _e472);
let _e478 = global_1.member.member_12.member_6;
let _e480 = (((_e347 * _e462) - _e478) * _e472);
let _e485 = global_1.member.member_12.member_4.member;
let _e487 = f32(bitcast<i32>(_e485));
let _e489 = select(0f, _e473, (_e473 > 0f));
let _e496 = global_1.member.member_12.member_18.member_1;
let _e499 = ((_e473 - _e487) * _e496);
let _e504 = global_1.member.member_12.member_18.member_2;
let _e506 = select(0f, _e499, (_e499 > 0f));
let _e508 = (_e504 + _e506);
let _e513 = (-(_e473) * _e496);
let _e515 = select(0f, _e513, (_e513 > 0f));
let _e517 = (_e504 + _e515);
let _e524 = (((_e504 + (select(_e487, _e489, (_e489 < _e487)) * _e496)) + (((_e506 * _e504) / select(1e-12f, _e508, (_e508 > 1e-12f))) - ((_e515 * _e504) / select(1e-12f, _e517, (_e517 > 1e-12f))))) - 0.5f);
let _e529 = global_1.member.member_12.member_4.member_1;
let _e531 = f32(bitcast<i32>(_e529));
let _e533 = select(0f, _e480, (_e480 > 0f));
let _e538 = ((_e480 - _e531) * _e496);
let _e540 = select(0f, _e538, (_e538 > 0f));
let _e542 = (_e504 + _e540);
let _e547 = (-(_e480) * _e496);
let _e549 = select(0f, _e547, (_e547 > 0f));
let _e551 = (_e504 + _e549);
let _e558 = (((_e504 + (select(_e531, _e533, (_e533 < _e531)) * _e496)) + (((_e540 * _e504) / select(1e-12f, _e542, (_e542 > 1e-12f))) - ((_e549 * _e504) / select(1e-12f, _e551, (_e551 > 1e-12f))))) - 0.5f);
let _e560 = f32((_e445 - 2i));
let _e562 = select(0f, _e524, (_e524 > 0f));
let _e564 = select(_e560, _e562, (_e562 < _e560));
let _e571 = select(0i, select(select(i32(_e564), i32(-2147483648), (_e564 < -2147483600f)), 2147483647i, (_e564 > 2147483500f)), (_e564 == _e564));
let _e575 = (_e571 - select(0i, 1i, (_e564 < f32(_e571))));
let _e577 = f32((_e452 - 2i));
let _e579 = select(0f, _e558, (_e558 > 0f));
let _e581 = select(_e577, _e579, (_e579 < _e577));
let _e588 = select(0i, select(select(i32(_e581), i32(-2147483648), (_e581 < -2147483600f)), 2147483647i, (_e581 > 2147483500f)), (_e581 == _e581));
let _e592 = (_e588 - select(0i, 1i, (_e581 < f32(_e588))));
let _e594 = (_e524 - f32(_e575));
let _e596 = select(0f, _e594, (_e594 > 0f));
let _e598 = select(1f, _e596, (_e596 < 1f));
let _e600 = (_e558 - f32(_e592));
let _e602 = select(0f, _e600, (_e600 > 0f));
let _e604 = select(1f, _e602, (_e602 < 1f));
if _e264 {
let _e609 = global_1.member.member_12.member_18.member_4;
phi_865_ = _e609;
} else {
let _e614 = global_1.member.member_12.member_18.member_3;
phi_865_ = _e614;
}
let _e616 = phi_865_;
let _e620 = ((bitcast<i32>(_e616) + (_e592 * _e445)) + _e575);
let _e621 = (_e445 * _e452);
let _e623 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e625 = select(_e623, _e620, (_e620 < _e623));
let _e631 = global_3.member[bitcast<u32>(select(0i, _e625, (_e625 > 0i)))];
let _e632 = bitcast<f32>(_e631);
let _e633 = (_e620 + 1i);
let _e635 = select(_e623, _e633, (_e633 < _e623));
let _e641 = global_3.member[bitcast<u32>(select(0i, _e635, (_e635 > 0i)))];
let _e645 = (_e632 + ((bitcast<f32>(_e641) - _e632) * _e598));
let _e646 = (_e620 + _e445);
let _e648 = select(_e623, _e646, (_e646 < _e623));
let _e654 = global_3.member[bitcast<u32>(select(0i, _e648, (_e648 > 0i)))];
let _e655 = bitcast<f32>(_e654);
let _e656 = (_e646 + 1i);
let _e658 = select(_e623, _e656, (_e656 < _e623));
let _e664 = global_3.member[bitcast<u32>(select(0i, _e658, (_e658 > 0i)))];
let _e671 = (_e645 + (((_e655 + ((bitcast<f32>(_e664) - _e655) * _e598)) - _e645) * _e604));
let _e672 = (_e620 + _e621);
let _e674 = select(_e623, _e672, (_e672 < _e623));
let _e680 = global_3.member[bitcast<u32>(select(0i, _e674, (_e674 > 0i)))];
let _e681 = bitcast<f32>(_e680);
let _e682 = (_e672 + 1i);
let _e684 = select(_e623, _e682, (_e682 < _e623));
let _e690 = global_3.member[bitcast<u32>(select(0i, _e684, (_e684 > 0i)))];
let _e694 = (_e681 + ((bitcast<f32>(_e690) - _e681) * _e598));
let _e695 = (_e672 + _e445);
let _e697 = select(_e623, _e695, (_e695 < _e623));
let _e703 = global_3.member[bitcast<u32>(select(0i, _e697, (_e697 > 0i)))];
let _e704 = bitcast<f32>(_e703);
let _e705 = (_e695 + 1i);
let _e707 = select(_e623, _e705, (_e705 < _e623));
let _e713 = global_3.member[bitcast<u32>(select(0i, _e707, (_e707 > 0i)))];
let _e720 = (_e694 + (((_e704 + ((bitcast<f32>(_e713) - _e704) * _e598)) - _e694) * _e604));
let _e722 = (_e620 + (2i * _e621));
let _e724 = select(_e623, _e722, (_e722 < _e623));
let _e730 = global_3.member[bitcast<u32>(select(0i, _e724, (_e724 > 0i)))];
let _e731 = bitcast<f32>(_e730);
let _e732 = (_e722 + 1i);
let _e734 = select(_e623, _e732, (_e732 < _e623));
let _e740 = global_3.member[bitcast<u32>(select(0i, _e734, (_e734 > 0i)))];
let _e744 = (_e731 + ((bitcast<f32>(_e740) - _e731) * _e598));
let _e745 = (_e722 + _e445);
let _e747 = select(_e623, _e745, (_e745 < _e623));
let _e753 = global_3.member[bitcast<u32>(select(0i, _e747, (_e747 > 0i)))];
let _e754 = bitcast<f32>(_e753);
let _e755 = (_e745 + 1i);
let _e757 = select(_e623, _e755, (_e755 < _e623));
let _e763 = global_3.member[bitcast<u32>(select(0i, _e757, (_e757 > 0i)))];
let _e770 = (_e744 + (((_e754 + ((bitcast<f32>(_e763) - _e754) * _e598)) - _e744) * _e604));
let _e772 = (_e366 == 0u);
if _e772 {
phi_1263_ = vec3<f32>(_e671, _e720, _e770);
} else {
if _e772 {
phi_1202_ = 1f;
} else {
let _e777 = global_1.member.member_12.member_20.member;
let _e785 = (((_e777.member * _e375) + (_e777.member_1 * _e376)) + (_e777.member_2 * _e377));
let _e789 = (_e375 - (_e777.member * _e785));
let _e790 = (_e376 - (_e777.member_1 * _e785));
let _e791 = (_e377 - (_e777.member_2 * _e785));
let _e796 = (((_e789 * _e789) + (_e790 * _e790)) + (_e791 * _e791));
let _e807 = global_1.member.member_12.member_20.member_1;
let _e813 = global_1.member.member_12.member_20.member_2;
let _e814 = ((_e807 - (sqrt(select(0f, _e796, (_e796 > 0f))) / select(1e-20f, _e785, (_e785 > 1e-20f)))) * _e813);
let _e816 = select(0f, _e814, (_e814 > 0f));
let _e818 = select(1f, _e816, (_e816 < 1f));
phi_1202_ = select(1f, select(0f, ((_e818 * _e818) * (3f - (2f * _e818))), (_e785 > 0f)), (_e813 > 0f));
}
let _e828 = phi_1202_;
let _e830 = select(0f, 1f, (_e377 > 0f));
let _e834 = ((_e671 * _e830) + _e828);
let _e835 = ((_e720 * _e830) + _e828);
let _e836 = ((_e770 * _e830) + _e828);
if _e772 {
phi_1258_ = 1f;
} else {
phi_1258_ = (1f / select(1e-12f, _e382, (_e382 > 1e-12f)));
}
let _e847 = phi_1258_;
phi_1263_ = vec3<f32>((select(0f, _e834, (_e834 > 0f)) * _e847), (select(0f, _e835, (_e835 > 0f)) * _e847), (select(0f, _e836, (_e836 > 0f)) * _e847));
}
let _e853 = phi_1263_;
let _e857 = global_1.member.member_11.member_1;
phi_1523_ = type_28((vec3<f32>(_e857.member, _e857.member_1, _e857.member_2) * _e853), _e433);
} else {
let _e864 = (_e366 == 0u);
if _e864 {
let _e868 = global_1.member.member_11.member_1;
let _e876 = global_1.member.member_11.member;
phi_1522_ = type_28(vec3<f32>(_e868.member, _e868.member_1, _e868.member_2), vec3<f32>(_e876.member, _e876.member_1, _e876.member_2));
} else {
let _e885 = global_1.member.member_11.member_1;
if _e864 {
phi_1366_ = 1f;
} else {
phi_1366_ = (1f / select(1e-12f, _e382, (_e382 > 1e-12f)));
}
let _e893 = phi_1366_;
if _e864 {
phi_1450_ = 1f;
} else {
let _e898 = global_1.member.member_12.member_20.member;
let _e906 = (((_e898.member * _e375) + (_e898.member_1 * _e376)) + (_e898.member_2 * _e377));
let _e910 = (_e375 - (_e898.member * _e906));
let _e911 = (_e376 - (_e898.member_1 * _e906));
let _e912 = (_e377 - (_e898.member_2 * _e906));
let _e917 = (((_e910 * _e910) + (_e911 * _e911)) + (_e912 * _e912));
let _e928 = global_1.member.member_12.member_20.member_1;
let _e934 = global_1.member.member_12.member_20.member_2;
let _e935 = ((_e928 - (sqrt(select(0f, _e917, (_e917 > 0f))) / select(1e-20f, _e906, (_e906 > 1e-20f)))) * _e934);
let _e937 = select(0f, _e935, (_e935 > 0f));
let _e939 = select(1f, _e937, (_e937 < 1f));
phi_1450_ = select(1f, select(0f, ((_e939 * _e939) * (3f - (2f * _e939))), (_e906 > 0f)), (_e934 > 0f));
}
let _e949 = phi_1450_;
let _e950 = (_e893 * _e949);
phi_1522_ = type_28(vec3<f32>((_e885.member * _e950), (_e885.member_1 * _e950), (_e885.member_2 * _e950)), _e433);
}
let _e957 = phi_1522_;
phi_1523_ = _e957;
}
let _e959 = phi_1523_;
let _e968 = (((_e959.member_1.x * _e959.member_1.x) + (_e959.member_1.y * _e959.member_1.y)) + (_e959.member_1.z * _e959.member_1.z));
let _e971 = sqrt(select(0f, _e968, (_e968 > 0f)));
let _e977 = (1e-6f * _e971);
let _e981 = select((_e971 / select(_e977, _e959.member_1.z, (_e959.member_1.z > _e977))), 1f, ((_e436 & 8u) != 0u));
let _e990 = global_1.member.member_20;
let _e1002 = (-((((select(_e281.member, _e270.member, _e264) * _e959.member_1.x) + (select(_e281.member_1, _e270.member_1, _e264) * _e959.member_1.y)) + (select(_e281.member_2, _e270.member_2, _e264) * _e959.member_1.z))) / select(1e-20f, _e971, (_e971 > 1e-20f)));
let _e1007 = bitcast<f32>((bitcast<u32>(select(0f, _e1002, (_e1002 > 0f))) & 2147483647u));
let _e1017 = select(0f, 1f, _e305);
global_2.member[_e68] = _e186;
global_2.member[(_e66 + _e68)] = _e187;
global_2.member[((2u * _e66) + _e68)] = _e188;
global_2.member[((3u * _e66) + _e68)] = (_e179 * _e199);
global_2.member[((4u * _e66) + _e68)] = (_e180 * _e199);
global_2.member[((5u * _e66) + _e68)] = (1f * _e199);
global_2.member[((6u * _e66) + _e68)] = 0f;
global_2.member[((7u * _e66) + _e68)] = _e1017;
global_2.member[((8u * _e66) + _e68)] = select(0f, (_e306 * _e178), _e305);
global_2.member[((9u * _e66) + _e68)] = select(0f, (select(_e286.member, _e275.member, _e264) * (((_e959.member.x * _e981) * _e1007) + _e990.member)), _e305);
global_2.member[((10u * _e66) + _e68)] = select(0f, (select(_e286.member_1, _e275.member_1, _e264) * (((_e959.member.y * _e981) * _e1007) + _e990.member_1)), _e305);
global_2.member[((11u * _e66) + _e68)] = select(0f, (select(_e286.member_2, _e275.member_2, _e264) * (((_e959.member.z * _e981) * _e1007) + _e990.member_2)), _e305);
global_2.member[((12u * _e66) + _e68)] = _e1017;
global_2.member[((13u * _e66) + _e68)] = 1f;
global_2.member[((14u * _e66) + _e68)] = 1f;
global_2.member[((15u * _e66) + _e68)] = 1f;
global_2.member[((16u * _e66) + _e68)] = 0f;
global_2.member[((17u * _e66) + _e68)] = -1.2676506e30f;
}
}
break;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
