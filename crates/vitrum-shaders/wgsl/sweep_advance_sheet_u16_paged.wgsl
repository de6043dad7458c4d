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
member: u32,
member_1: u32,
}
struct type_19 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_20 {
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
struct type_21 {
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
struct type_22 {
member: type_5,
member_1: type_5,
}
struct type_23 {
member: type_7,
member_1: u32,
}
struct type_24 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_18,
member_4: u32,
member_5: type_19,
member_6: type_20,
member_7: type_20,
member_8: type_21,
member_9: type_22,
member_10: f32,
member_11: type_19,
member_12: type_4,
member_13: type_9,
member_14: type_23,
member_15: type_23,
member_16: type_23,
member_17: type_23,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_25 {
member: type_24,
}
struct type_28 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_25;
@group(0) @binding(1)
var<storage> global_2: type_16;
@group(0) @binding(3)
var<storage> global_3: type_16;
@group(0) @binding(4)
var<storage> global_4: type_16;
@group(0) @binding(5)
var<storage> global_5: type_11;
@group(0) @binding(6)
var<storage, read_write> global_6: type_11;
fn function_() {
var local: type_28;
var local_1: vec3<f32>;
var local_2: type_28;
var local_3: vec3<f32>;
var local_4: type_28;
var local_5: vec3<f32>;
var phi_4007_: type_29;
var phi_4708_: type_30;
var phi_5632_: type_5;
var phi_6658_: vec3<f32>;
var phi_6659_: bool;
switch bitcast<i32>(0u) {
default: {
let _e89 = global;
let _e92 = arrayLength((&global_2.member));
let _e96 = arrayLength((&global_4.member));
let _e103 = global_1.member.member_2;
let _e106 = global_1.member.member;
let _e114 = (_e89.x + _e103.member);
let _e116 = (_e89.y + _e103.member_1);
if (_e114 < _e103.member_2) {
if (_e116 < _e103.member_3) {
let _e119 = (_e106.member * _e106.member_1);
let _e121 = ((_e116 * _e106.member) + _e114);
let _e122 = bitcast<i32>(_e121);
let _e124 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e126 = select(_e124, _e122, (_e122 < _e124));
let _e132 = global_6.member[bitcast<u32>(select(0i, _e126, (_e126 > 0i)))];
let _e133 = (_e119 + _e121);
let _e134 = bitcast<i32>(_e133);
let _e136 = select(_e124, _e134, (_e134 < _e124));
let _e142 = global_6.member[bitcast<u32>(select(0i, _e136, (_e136 > 0i)))];
let _e144 = ((2u * _e119) + _e121);
let _e145 = bitcast<i32>(_e144);
let _e147 = select(_e124, _e145, (_e145 < _e124));
let _e153 = global_6.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e155 = ((3u * _e119) + _e121);
let _e156 = bitcast<i32>(_e155);
let _e158 = select(_e124, _e156, (_e156 < _e124));
let _e164 = global_6.member[bitcast<u32>(select(0i, _e158, (_e158 > 0i)))];
let _e166 = ((4u * _e119) + _e121);
let _e167 = bitcast<i32>(_e166);
let _e169 = select(_e124, _e167, (_e167 < _e124));
let _e175 = global_6.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e177 = ((5u * _e119) + _e121);
let _e178 = bitcast<i32>(_e177);
let _e180 = select(_e124, _e178, (_e178 < _e124));
let _e186 = global_6.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e188 = ((6u * _e119) + _e121);
let _e189 = bitcast<i32>(_e188);
let _e191 = select(_e124, _e189, (_e189 < _e124));
let _e197 = global_6.member[bitcast<u32>(select(0i, _e191, (_e191 > 0i)))];
let _e199 = ((7u * _e119) + _e121);
let _e200 = bitcast<i32>(_e199);
let _e202 = select(_e124, _e200, (_e200 < _e124));
let _e208 = global_6.member[bitcast<u32>(select(0i, _e202, (_e202 > 0i)))];
let _e210 = ((8u * _e119) + _e121);
let _e211 = bitcast<i32>(_e210);
let _e213 = select(_e124, _e211, (_e211 < _e124));
let _e219 = global_6.member[bitcast<u32>(select(0i, _e213, (_e213 > 0i)))];
let _e221 = ((9u * _e119) + _e121);
let _e222 = bitcast<i32>(_e221);
let _e224 = select(_e124, _e222, (_e222 < _e124));
let _e230 = global_6.member[bitcast<u32>(select(0i, _e224, (_e224 > 0i)))];
let _e232 = ((10u * _e119) + _e121);
let _e233 = bitcast<i32>(_e232);
let _e235 = select(_e124, _e233, (_e233 < _e124));
let _e241 = global_6.member[bitcast<u32>(select(0i, _e235, (_e235 > 0i)))];
let _e246 = global_1.member.member_5.member_2;
let _e249 = (1f / select(1e-6f, _e197, (_e197 > 1e-6f)));
let _e253 = global_1.member.member_8.member_5;
let _e254 = (_e246 * _e253);
let _e259 = global_1.member.member_8.member_6;
let _e261 = (((_e175 * _e249) - _e259) * _e254);
let _e266 = global_1.member.member_8.member_7;
let _e268 = (((_e186 * _e249) - _e266) * _e254);
let _e272 = ((f32(bitcast<i32>(_e114)) - 0.5f) + _e132);
let _e276 = global_1.member.member_8.member_1;
let _e277 = (_e276 + 1u);
let _e279 = select(1u, _e277, (_e277 > 0u));
let _e280 = (_e279 == 0u);
if _e280 {
break;
}
let _e285 = ((f32(bitcast<i32>((_e116 % _e279))) - 0.5f) + _e142);
let _e289 = global_1.member.member_5.member;
let _e293 = global_1.member.member_8.member_8;
let _e294 = (_e289 - _e293);
let _e298 = global_1.member.member_8.member_2;
let _e305 = global_1.member.member_8.member_4;
let _e307 = ((_e298 + (_e259 * _e294)) + ((_e272 + 0.5f) * _e305));
let _e311 = global_1.member.member_8.member_3;
let _e316 = ((_e311 + (_e266 * _e294)) + ((_e285 + 0.5f) * _e305));
let _e322 = global_1.member.member_5.member_1;
let _e323 = (_e322 - _e293);
let _e328 = ((_e298 + (_e259 * _e323)) + (((_e272 + _e261) + 0.5f) * _e305));
let _e333 = ((_e311 + (_e266 * _e323)) + (((_e285 + _e268) + 0.5f) * _e305));
if _e280 {
break;
}
let _e336 = bitcast<i32>(((_e116 / _e279) * 3u));
let _e338 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e340 = select(_e338, _e336, (_e336 < _e338));
let _e346 = global_5.member[bitcast<u32>(select(0i, _e340, (_e340 > 0i)))];
let _e347 = (_e336 + 1i);
let _e349 = select(_e338, _e347, (_e347 < _e338));
let _e355 = global_5.member[bitcast<u32>(select(0i, _e349, (_e349 > 0i)))];
let _e356 = (_e336 + 2i);
let _e358 = select(_e338, _e356, (_e356 < _e338));
let _e364 = global_5.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e367 = (1f / select(1e-6f, _e364, (_e364 > 1e-6f)));
let _e370 = (((_e346 * _e367) - _e259) * _e254);
let _e373 = (((_e355 * _e367) - _e266) * _e254);
let _e385 = global_1.member.member_6.member;
let _e396 = ((((_e385.member.member * _e307) + (_e385.member.member_1 * _e316)) + (_e385.member.member_2 * _e289)) + _e385.member_1);
let _e400 = global_1.member.member_6.member_1;
let _e411 = ((((_e400.member.member * _e307) + (_e400.member.member_1 * _e316)) + (_e400.member.member_2 * _e289)) + _e400.member_1);
let _e415 = global_1.member.member_6.member_2;
let _e426 = ((((_e415.member.member * _e307) + (_e415.member.member_1 * _e316)) + (_e415.member.member_2 * _e289)) + _e415.member_1);
let _e432 = ((((_e385.member.member * _e328) + (_e385.member.member_1 * _e333)) + (_e385.member.member_2 * _e322)) + _e385.member_1);
let _e438 = ((((_e400.member.member * _e328) + (_e400.member.member_1 * _e333)) + (_e400.member.member_2 * _e322)) + _e400.member_1);
let _e444 = ((((_e415.member.member * _e328) + (_e415.member.member_1 * _e333)) + (_e415.member.member_2 * _e322)) + _e415.member_1);
let _e448 = global_1.member.member_6.member_4;
let _e453 = global_1.member.member_6.member_3.member;
let _e454 = (_e453 - 0.5f);
let _e456 = select(-0.5f, _e432, (_e432 > -0.5f));
let _e458 = select(_e454, _e456, (_e456 < _e454));
let _e463 = global_1.member.member_6.member_3.member_1;
let _e464 = (_e463 - 0.5f);
let _e466 = select(-0.5f, _e438, (_e438 > -0.5f));
let _e468 = select(_e464, _e466, (_e466 < _e464));
let _e473 = global_1.member.member_6.member_3.member_2;
let _e474 = (_e473 - 0.5f);
let _e476 = select(-0.5f, _e444, (_e444 > -0.5f));
let _e478 = select(_e474, _e476, (_e476 < _e474));
let _e479 = (_e432 - _e396);
let _e480 = (_e438 - _e411);
let _e481 = (_e444 - _e426);
let _e484 = bitcast<f32>((bitcast<u32>(_e479) & 2147483647u));
let _e487 = bitcast<f32>((bitcast<u32>(_e480) & 2147483647u));
let _e489 = select(_e487, _e484, (_e484 > _e487));
let _e492 = bitcast<f32>((bitcast<u32>(_e481) & 2147483647u));
let _e501 = bitcast<f32>((bitcast<u32>((_e432 - _e458)) & 2147483647u));
let _e504 = bitcast<f32>((bitcast<u32>((_e438 - _e468)) & 2147483647u));
let _e506 = select(_e504, _e501, (_e501 > _e504));
let _e509 = bitcast<f32>((bitcast<u32>((_e444 - _e478)) & 2147483647u));
let _e513 = (_e458 + 0.5f);
let _e514 = (_e453 - 1f);
let _e516 = select(0f, _e513, (_e513 > 0f));
let _e518 = select(_e514, _e516, (_e516 < _e514));
let _e525 = select(0i, select(select(i32(_e518), i32(-2147483648), (_e518 < -2147483600f)), 2147483647i, (_e518 > 2147483500f)), (_e518 == _e518));
let _e533 = global_1.member.member_6.member_12;
let _e534 = (_e533 & 31u);
let _e537 = (_e468 + 0.5f);
let _e538 = (_e463 - 1f);
let _e540 = select(0f, _e537, (_e537 > 0f));
let _e542 = select(_e538, _e540, (_e540 < _e538));
let _e549 = select(0i, select(select(i32(_e542), i32(-2147483648), (_e542 < -2147483600f)), 2147483647i, (_e542 > 2147483500f)), (_e542 == _e542));
let _e556 = (_e478 + 0.5f);
let _e557 = (_e473 - 1f);
let _e559 = select(0f, _e556, (_e556 > 0f));
let _e561 = select(_e557, _e559, (_e559 < _e557));
let _e568 = select(0i, select(select(i32(_e561), i32(-2147483648), (_e561 < -2147483600f)), 2147483647i, (_e561 > 2147483500f)), (_e561 == _e561));
let _e579 = global_1.member.member_6.member_9.member;
let _e585 = global_1.member.member_6.member_9.member_1;
let _e590 = global_1.member.member_6.member_10;
let _e596 = ((bitcast<i32>(_e590) + ((_e525 - select(0i, 1i, (_e518 < f32(_e525)))) >> bitcast<u32>(_e534))) + (bitcast<i32>(_e579) * (((_e549 - select(0i, 1i, (_e542 < f32(_e549)))) >> bitcast<u32>(_e534)) + (bitcast<i32>(_e585) * ((_e568 - select(0i, 1i, (_e561 < f32(_e568)))) >> bitcast<u32>(_e534))))));
let _e598 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e600 = select(_e598, _e596, (_e596 < _e598));
let _e606 = global_3.member[bitcast<u32>(select(0i, _e600, (_e600 > 0i)))];
let _e612 = global_1.member.member_1;
let _e619 = (((_e612 & 64u) != 0u) || ((((select(_e492, _e489, (_e489 > _e492)) <= _e448) && ((select(_e509, _e506, (_e506 > _e509)) > _e448) || (_e606 != 0u))) && true) && ((_e612 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e261 == 0f) && (_e268 == 0f)) && (_e370 == 0f)) && (_e373 == 0f))), _e619), (_e241 == 0f)) > 1u) {
if _e280 {
break;
}
if _e280 {
break;
}
let _e626 = (_e106.member_2 == 2u);
let _e629 = (((_e106.member_2 == 1u) || _e626) || (_e106.member_2 == 5u));
if _e629 {
let _e631 = select(-1f, _e458, (_e458 > -1f));
let _e633 = select(_e453, _e631, (_e631 < _e453));
let _e640 = select(0i, select(select(i32(_e633), i32(-2147483648), (_e633 < -2147483600f)), 2147483647i, (_e633 > 2147483500f)), (_e633 == _e633));
let _e644 = (_e640 - select(0i, 1i, (_e633 < f32(_e640))));
let _e646 = select(-1f, _e468, (_e468 > -1f));
let _e648 = select(_e463, _e646, (_e646 < _e463));
let _e655 = select(0i, select(select(i32(_e648), i32(-2147483648), (_e648 < -2147483600f)), 2147483647i, (_e648 > 2147483500f)), (_e648 == _e648));
let _e659 = (_e655 - select(0i, 1i, (_e648 < f32(_e655))));
let _e661 = select(-1f, _e478, (_e478 > -1f));
let _e663 = select(_e473, _e661, (_e661 < _e473));
let _e670 = select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < -2147483600f)), 2147483647i, (_e663 > 2147483500f)), (_e663 == _e663));
let _e674 = (_e670 - select(0i, 1i, (_e663 < f32(_e670))));
let _e678 = global_1.member.member_6.member_7;
let _e682 = global_1.member.member_6.member_8;
let _e683 = (_e644 + 1i);
let _e684 = (_e659 + 1i);
let _e685 = (_e674 + 1i);
let _e690 = global_1.member.member_6.member_11.member;
let _e696 = global_1.member.member_6.member_11.member_1;
let _e707 = ((_e683 >> bitcast<u32>(4i)) + (bitcast<i32>(_e690) * ((_e684 >> bitcast<u32>(4i)) + (bitcast<i32>(_e696) * (_e685 >> bitcast<u32>(4i))))));
let _e709 = (bitcast<i32>(_e92) - 1i);
let _e711 = select(_e709, _e707, (_e707 < _e709));
let _e717 = global_2.member[bitcast<u32>(select(0i, _e711, (_e711 > 0i)))];
let _e719 = (_e683 & 15i);
let _e722 = ((_e684 & 15i) * _e678);
let _e724 = (bitcast<i32>(_e717) + ((_e685 & 15i) * _e682));
let _e728 = (_e722 + _e678);
let _e730 = (_e722 + (2i * _e678));
let _e732 = (_e722 + (3i * _e678));
let _e733 = (_e724 + _e682);
let _e735 = (_e724 + (2i * _e682));
let _e737 = (_e724 + (3i * _e682));
local_4 = type_28(array<i32, 4>(_e719, (_e719 + 1i), (_e719 + 2i), (_e719 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e458 - f32(_e644)), (_e468 - f32(_e659)), (_e478 - f32(_e674)));
let _e748 = (_e733 + _e728);
let _e751 = local_4.member[0u];
let _e752 = (_e748 + _e751);
let _e754 = (_e752 >> bitcast<u32>(1i));
let _e757 = bitcast<u32>(((_e752 & 1i) * 16i));
let _e759 = select(_e709, _e754, (_e754 < _e709));
let _e764 = global_2.member[bitcast<u32>(select(0i, _e759, (_e759 > 0i)))];
let _e768 = (_e754 + 1i);
let _e770 = select(_e709, _e768, (_e768 < _e709));
let _e775 = global_2.member[bitcast<u32>(select(0i, _e770, (_e770 > 0i)))];
let _e782 = ((_e764 >> bitcast<u32>((_e757 & 31u))) | ((_e775 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e757) & 31u))));
let _e785 = local_4.member[2u];
let _e786 = (_e748 + _e785);
let _e788 = (_e786 >> bitcast<u32>(1i));
let _e791 = bitcast<u32>(((_e786 & 1i) * 16i));
let _e793 = select(_e709, _e788, (_e788 < _e709));
let _e798 = global_2.member[bitcast<u32>(select(0i, _e793, (_e793 > 0i)))];
let _e802 = (_e788 + 1i);
let _e804 = select(_e709, _e802, (_e802 < _e709));
let _e809 = global_2.member[bitcast<u32>(select(0i, _e804, (_e804 > 0i)))];
let _e816 = ((_e798 >> bitcast<u32>((_e791 & 31u))) | ((_e809 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e791) & 31u))));
let _e819 = local_4.member_1[0u];
let _e825 = f32(bitcast<i32>(((_e782 >> bitcast<u32>((_e819 & 31u))) & 65535u)));
let _e828 = local_4.member_1[1u];
let _e834 = f32(bitcast<i32>(((_e782 >> bitcast<u32>((_e828 & 31u))) & 65535u)));
let _e837 = local_4.member_1[4u];
let _e843 = f32(bitcast<i32>(((_e816 >> bitcast<u32>((_e837 & 31u))) & 65535u)));
let _e846 = local_4.member_1[5u];
let _e853 = local_5[0u];
let _e856 = (_e825 + ((_e834 - _e825) * _e853));
let _e857 = local_5[0u];
let _e860 = (_e834 + ((_e843 - _e834) * _e857));
let _e861 = local_5[0u];
let _e864 = (_e843 + ((f32(bitcast<i32>(((_e816 >> bitcast<u32>((_e846 & 31u))) & 65535u))) - _e843) * _e861));
let _e865 = (_e733 + _e730);
let _e866 = local_4.member[0u];
let _e867 = (_e865 + _e866);
let _e869 = (_e867 >> bitcast<u32>(1i));
let _e872 = bitcast<u32>(((_e867 & 1i) * 16i));
let _e874 = select(_e709, _e869, (_e869 < _e709));
let _e879 = global_2.member[bitcast<u32>(select(0i, _e874, (_e874 > 0i)))];
let _e883 = (_e869 + 1i);
let _e885 = select(_e709, _e883, (_e883 < _e709));
let _e890 = global_2.member[bitcast<u32>(select(0i, _e885, (_e885 > 0i)))];
let _e897 = ((_e879 >> bitcast<u32>((_e872 & 31u))) | ((_e890 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e872) & 31u))));
let _e898 = local_4.member[2u];
let _e899 = (_e865 + _e898);
let _e901 = (_e899 >> bitcast<u32>(1i));
let _e904 = bitcast<u32>(((_e899 & 1i) * 16i));
let _e906 = select(_e709, _e901, (_e901 < _e709));
let _e911 = global_2.member[bitcast<u32>(select(0i, _e906, (_e906 > 0i)))];
let _e915 = (_e901 + 1i);
let _e917 = select(_e709, _e915, (_e915 < _e709));
let _e922 = global_2.member[bitcast<u32>(select(0i, _e917, (_e917 > 0i)))];
let _e929 = ((_e911 >> bitcast<u32>((_e904 & 31u))) | ((_e922 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e904) & 31u))));
let _e930 = local_4.member_1[0u];
let _e936 = f32(bitcast<i32>(((_e897 >> bitcast<u32>((_e930 & 31u))) & 65535u)));
let _e937 = local_4.member_1[1u];
let _e943 = f32(bitcast<i32>(((_e897 >> bitcast<u32>((_e937 & 31u))) & 65535u)));
let _e944 = local_4.member_1[4u];
let _e950 = f32(bitcast<i32>(((_e929 >> bitcast<u32>((_e944 & 31u))) & 65535u)));
let _e951 = local_4.member_1[5u];
let _e958 = local_5[0u];
let _e962 = local_5[0u];
let _e965 = (_e943 + ((_e950 - _e943) * _e962));
let _e966 = local_5[0u];
let _e970 = (_e735 + _e728);
let _e971 = local_4.member[0u];
let _e972 = (_e970 + _e971);
let _e974 = (_e972 >> bitcast<u32>(1i));
let _e977 = bitcast<u32>(((_e972 & 1i) * 16i));
let _e979 = select(_e709, _e974, (_e974 < _e709));
let _e984 = global_2.member[bitcast<u32>(select(0i, _e979, (_e979 > 0i)))];
let _e988 = (_e974 + 1i);
let _e990 = select(_e709, _e988, (_e988 < _e709));
let _e995 = global_2.member[bitcast<u32>(select(0i, _e990, (_e990 > 0i)))];
let _e1002 = ((_e984 >> bitcast<u32>((_e977 & 31u))) | ((_e995 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e977) & 31u))));
let _e1003 = local_4.member[2u];
let _e1004 = (_e970 + _e1003);
let _e1006 = (_e1004 >> bitcast<u32>(1i));
let _e1009 = bitcast<u32>(((_e1004 & 1i) * 16i));
let _e1011 = select(_e709, _e1006, (_e1006 < _e709));
let _e1016 = global_2.member[bitcast<u32>(select(0i, _e1011, (_e1011 > 0i)))];
let _e1020 = (_e1006 + 1i);
let _e1022 = select(_e709, _e1020, (_e1020 < _e709));
let _e1027 = global_2.member[bitcast<u32>(select(0i, _e1022, (_e1022 > 0i)))];
let _e1034 = ((_e1016 >> bitcast<u32>((_e1009 & 31u))) | ((_e1027 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1009) & 31u))));
let _e1035 = local_4.member_1[0u];
let _e1041 = f32(bitcast<i32>(((_e1002 >> bitcast<u32>((_e1035 & 31u))) & 65535u)));
let _e1042 = local_4.member_1[1u];
let _e1048 = f32(bitcast<i32>(((_e1002 >> bitcast<u32>((_e1042 & 31u))) & 65535u)));
let _e1049 = local_4.member_1[4u];
let _e1055 = f32(bitcast<i32>(((_e1034 >> bitcast<u32>((_e1049 & 31u))) & 65535u)));
let _e1056 = local_4.member_1[5u];
let _e1063 = local_5[0u];
let _e1066 = (_e1041 + ((_e1048 - _e1041) * _e1063));
let _e1067 = local_5[0u];
let _e1070 = (_e1048 + ((_e1055 - _e1048) * _e1067));
let _e1071 = local_5[0u];
let _e1074 = (_e1055 + ((f32(bitcast<i32>(((_e1034 >> bitcast<u32>((_e1056 & 31u))) & 65535u))) - _e1055) * _e1071));
let _e1075 = (_e735 + _e730);
let _e1076 = local_4.member[0u];
let _e1077 = (_e1075 + _e1076);
let _e1079 = (_e1077 >> bitcast<u32>(1i));
let _e1082 = bitcast<u32>(((_e1077 & 1i) * 16i));
let _e1084 = select(_e709, _e1079, (_e1079 < _e709));
let _e1089 = global_2.member[bitcast<u32>(select(0i, _e1084, (_e1084 > 0i)))];
let _e1093 = (_e1079 + 1i);
let _e1095 = select(_e709, _e1093, (_e1093 < _e709));
let _e1100 = global_2.member[bitcast<u32>(select(0i, _e1095, (_e1095 > 0i)))];
let _e1107 = ((_e1089 >> bitcast<u32>((_e1082 & 31u))) | ((_e1100 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1082) & 31u))));
let _e1108 = local_4.member[2u];
let _e1109 = (_e1075 + _e1108);
let _e1111 = (_e1109 >> bitcast<u32>(1i));
let _e1114 = bitcast<u32>(((_e1109 & 1i) * 16i));
let _e1116 = select(_e709, _e1111, (_e1111 < _e709));
let _e1121 = global_2.member[bitcast<u32>(select(0i, _e1116, (_e1116 > 0i)))];
let _e1125 = (_e1111 + 1i);
let _e1127 = select(_e709, _e1125, (_e1125 < _e709));
let _e1132 = global_2.member[bitcast<u32>(select(0i, _e1127, (_e1127 > 0i)))];
let _e1139 = ((_e1121 >> bitcast<u32>((_e1114 & 31u))) | ((_e1132 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1114) & 31u))));
let _e1140 = local_4.member_1[0u];
let _e1146 = f32(bitcast<i32>(((_e1107 >> bitcast<u32>((_e1140 & 31u))) & 65535u)));
let _e1147 = local_4.member_1[1u];
let _e1153 = f32(bitcast<i32>(((_e1107 >> bitcast<u32>((_e1147 & 31u))) & 65535u)));
let _e1154 = local_4.member_1[4u];
let _e1160 = f32(bitcast<i32>(((_e1139 >> bitcast<u32>((_e1154 & 31u))) & 65535u)));
let _e1161 = local_4.member_1[5u];
let _e1168 = local_5[0u];
let _e1172 = local_5[0u];
let _e1175 = (_e1153 + ((_e1160 - _e1153) * _e1172));
let _e1176 = local_5[0u];
let _e1183 = local_4.member[1u];
let _e1184 = ((_e733 + _e722) + _e1183);
let _e1186 = (_e1184 >> bitcast<u32>(1i));
let _e1189 = bitcast<u32>(((_e1184 & 1i) * 16i));
let _e1191 = select(_e709, _e1186, (_e1186 < _e709));
let _e1196 = global_2.member[bitcast<u32>(select(0i, _e1191, (_e1191 > 0i)))];
let _e1200 = (_e1186 + 1i);
let _e1202 = select(_e709, _e1200, (_e1200 < _e709));
let _e1207 = global_2.member[bitcast<u32>(select(0i, _e1202, (_e1202 > 0i)))];
let _e1214 = ((_e1196 >> bitcast<u32>((_e1189 & 31u))) | ((_e1207 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1189) & 31u))));
let _e1217 = local_4.member_1[2u];
let _e1223 = f32(bitcast<i32>(((_e1214 >> bitcast<u32>((_e1217 & 31u))) & 65535u)));
let _e1226 = local_4.member_1[3u];
let _e1233 = local_5[0u];
let _e1236 = (_e1223 + ((f32(bitcast<i32>(((_e1214 >> bitcast<u32>((_e1226 & 31u))) & 65535u))) - _e1223) * _e1233));
let _e1238 = local_4.member[1u];
let _e1239 = ((_e733 + _e732) + _e1238);
let _e1241 = (_e1239 >> bitcast<u32>(1i));
let _e1244 = bitcast<u32>(((_e1239 & 1i) * 16i));
let _e1246 = select(_e709, _e1241, (_e1241 < _e709));
let _e1251 = global_2.member[bitcast<u32>(select(0i, _e1246, (_e1246 > 0i)))];
let _e1255 = (_e1241 + 1i);
let _e1257 = select(_e709, _e1255, (_e1255 < _e709));
let _e1262 = global_2.member[bitcast<u32>(select(0i, _e1257, (_e1257 > 0i)))];
let _e1269 = ((_e1251 >> bitcast<u32>((_e1244 & 31u))) | ((_e1262 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1244) & 31u))));
let _e1270 = local_4.member_1[2u];
let _e1276 = f32(bitcast<i32>(((_e1269 >> bitcast<u32>((_e1270 & 31u))) & 65535u)));
let _e1277 = local_4.member_1[3u];
let _e1284 = local_5[0u];
let _e1289 = local_4.member[1u];
let _e1290 = ((_e735 + _e722) + _e1289);
let _e1292 = (_e1290 >> bitcast<u32>(1i));
let _e1295 = bitcast<u32>(((_e1290 & 1i) * 16i));
let _e1297 = select(_e709, _e1292, (_e1292 < _e709));
let _e1302 = global_2.member[bitcast<u32>(select(0i, _e1297, (_e1297 > 0i)))];
let _e1306 = (_e1292 + 1i);
let _e1308 = select(_e709, _e1306, (_e1306 < _e709));
let _e1313 = global_2.member[bitcast<u32>(select(0i, _e1308, (_e1308 > 0i)))];
let _e1320 = ((_e1302 >> bitcast<u32>((_e1295 & 31u))) | ((_e1313 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1295) & 31u))));
let _e1321 = local_4.member_1[2u];
let _e1327 = f32(bitcast<i32>(((_e1320 >> bitcast<u32>((_e1321 & 31u))) & 65535u)));
let _e1328 = local_4.member_1[3u];
let _e1335 = local_5[0u];
let _e1338 = (_e1327 + ((f32(bitcast<i32>(((_e1320 >> bitcast<u32>((_e1328 & 31u))) & 65535u))) - _e1327) * _e1335));
let _e1340 = local_4.member[1u];
let _e1341 = ((_e735 + _e732) + _e1340);
let _e1343 = (_e1341 >> bitcast<u32>(1i));
let _e1346 = bitcast<u32>(((_e1341 & 1i) * 16i));
let _e1348 = select(_e709, _e1343, (_e1343 < _e709));
let _e1353 = global_2.member[bitcast<u32>(select(0i, _e1348, (_e1348 > 0i)))];
let _e1357 = (_e1343 + 1i);
let _e1359 = select(_e709, _e1357, (_e1357 < _e709));
let _e1364 = global_2.member[bitcast<u32>(select(0i, _e1359, (_e1359 > 0i)))];
let _e1371 = ((_e1353 >> bitcast<u32>((_e1346 & 31u))) | ((_e1364 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1346) & 31u))));
let _e1372 = local_4.member_1[2u];
let _e1378 = f32(bitcast<i32>(((_e1371 >> bitcast<u32>((_e1372 & 31u))) & 65535u)));
let _e1379 = local_4.member_1[3u];
let _e1386 = local_5[0u];
let _e1391 = local_4.member[1u];
let _e1392 = ((_e724 + _e728) + _e1391);
let _e1394 = (_e1392 >> bitcast<u32>(1i));
let _e1397 = bitcast<u32>(((_e1392 & 1i) * 16i));
let _e1399 = select(_e709, _e1394, (_e1394 < _e709));
let _e1404 = global_2.member[bitcast<u32>(select(0i, _e1399, (_e1399 > 0i)))];
let _e1408 = (_e1394 + 1i);
let _e1410 = select(_e709, _e1408, (_e1408 < _e709));
let _e1415 = global_2.member[bitcast<u32>(select(0i, _e1410, (_e1410 > 0i)))];
let _e1422 = ((_e1404 >> bitcast<u32>((_e1397 & 31u))) | ((_e1415 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1397) & 31u))));
let _e1423 = local_4.member_1[2u];
let _e1429 = f32(bitcast<i32>(((_e1422 >> bitcast<u32>((_e1423 & 31u))) & 65535u)));
let _e1430 = local_4.member_1[3u];
let _e1437 = local_5[0u];
let _e1440 = (_e1429 + ((f32(bitcast<i32>(((_e1422 >> bitcast<u32>((_e1430 & 31u))) & 65535u))) - _e1429) * _e1437));
let _e1442 = local_4.member[1u];
let _e1443 = ((_e737 + _e728) + _e1442);
let _e1445 = (_e1443 >> bitcast<u32>(1i));
let _e1448 = bitcast<u32>(((_e1443 & 1i) * 16i));
let _e1450 = select(_e709, _e1445, (_e1445 < _e709));
let _e1455 = global_2.member[bitcast<u32>(select(0i, _e1450, (_e1450 > 0i)))];
let _e1459 = (_e1445 + 1i);
let _e1461 = select(_e709, _e1459, (_e1459 < _e709));
let _e1466 = global_2.member[bitcast<u32>(select(0i, _e1461, (_e1461 > 0i)))];
let _e1473 = ((_e1455 >> bitcast<u32>((_e1448 & 31u))) | ((_e1466 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1448) & 31u))));
let _e1474 = local_4.member_1[2u];
let _e1480 = f32(bitcast<i32>(((_e1473 >> bitcast<u32>((_e1474 & 31u))) & 65535u)));
let _e1481 = local_4.member_1[3u];
let _e1488 = local_5[0u];
let _e1491 = (_e1480 + ((f32(bitcast<i32>(((_e1473 >> bitcast<u32>((_e1481 & 31u))) & 65535u))) - _e1480) * _e1488));
let _e1493 = local_4.member[1u];
let _e1494 = ((_e724 + _e730) + _e1493);
let _e1496 = (_e1494 >> bitcast<u32>(1i));
let _e1499 = bitcast<u32>(((_e1494 & 1i) * 16i));
let _e1501 = select(_e709, _e1496, (_e1496 < _e709));
let _e1506 = global_2.member[bitcast<u32>(select(0i, _e1501, (_e1501 > 0i)))];
let _e1510 = (_e1496 + 1i);
let _e1512 = select(_e709, _e1510, (_e1510 < _e709));
let _e1517 = global_2.member[bitcast<u32>(select(0i, _e1512, (_e1512 > 0i)))];
let _e1524 = ((_e1506 >> bitcast<u32>((_e1499 & 31u))) | ((_e1517 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1499) & 31u))));
let _e1525 = local_4.member_1[2u];
let _e1531 = f32(bitcast<i32>(((_e1524 >> bitcast<u32>((_e1525 & 31u))) & 65535u)));
let _e1532 = local_4.member_1[3u];
let _e1539 = local_5[0u];
let _e1544 = local_4.member[1u];
let _e1545 = ((_e737 + _e730) + _e1544);
let _e1547 = (_e1545 >> bitcast<u32>(1i));
let _e1550 = bitcast<u32>(((_e1545 & 1i) * 16i));
let _e1552 = select(_e709, _e1547, (_e1547 < _e709));
let _e1557 = global_2.member[bitcast<u32>(select(0i, _e1552, (_e1552 > 0i)))];
let _e1561 = (_e1547 + 1i);
let _e1563 = select(_e709, _e1561, (_e1561 < _e709));
let _e1568 = global_2.member[bitcast<u32>(select(0i, _e1563, (_e1563 > 0i)))];
let _e1575 = ((_e1557 >> bitcast<u32>((_e1550 & 31u))) | ((_e1568 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1550) & 31u))));
let _e1576 = local_4.member_1[2u];
let _e1582 = f32(bitcast<i32>(((_e1575 >> bitcast<u32>((_e1576 & 31u))) & 65535u)));
let _e1583 = local_4.member_1[3u];
let _e1590 = local_5[0u];
let _e1595 = local_5[1u];
let _e1598 = (_e860 + ((_e965 - _e860) * _e1595));
let _e1599 = local_5[1u];
let _e1602 = (_e1070 + ((_e1175 - _e1070) * _e1599));
let _e1603 = local_5[1u];
let _e1606 = (_e856 + (((_e936 + ((_e943 - _e936) * _e958)) - _e856) * _e1603));
let _e1607 = local_5[1u];
let _e1612 = local_5[2u];
let _e1616 = local_5[1u];
let _e1619 = (_e864 + (((_e950 + ((f32(bitcast<i32>(((_e929 >> bitcast<u32>((_e951 & 31u))) & 65535u))) - _e950) * _e966)) - _e864) * _e1616));
let _e1620 = local_5[1u];
let _e1624 = local_5[2u];
let _e1628 = local_5[1u];
let _e1631 = (_e1236 + ((_e860 - _e1236) * _e1628));
let _e1632 = local_5[1u];
let _e1636 = local_5[2u];
let _e1640 = local_5[1u];
let _e1643 = (_e965 + (((_e1276 + ((f32(bitcast<i32>(((_e1269 >> bitcast<u32>((_e1277 & 31u))) & 65535u))) - _e1276) * _e1284)) - _e965) * _e1640));
let _e1644 = local_5[1u];
let _e1648 = local_5[2u];
let _e1652 = local_5[1u];
let _e1655 = (_e1440 + (((_e1531 + ((f32(bitcast<i32>(((_e1524 >> bitcast<u32>((_e1532 & 31u))) & 65535u))) - _e1531) * _e1539)) - _e1440) * _e1652));
let _e1656 = local_5[2u];
let _e1660 = local_5[1u];
let _e1664 = local_5[2u];
let _e1668 = local_5[2u];
let _e1675 = global_1.member.member_6.member_5;
let _e1680 = global_1.member.member_6.member_6;
let _e1681 = (((_e1598 + ((_e1602 - _e1598) * _e1668)) * _e1675) + _e1680);
let _e1683 = select(0f, _e1681, (_e1681 > 0f));
let _e1685 = select(1f, _e1683, (_e1683 < 1f));
let _e1687 = (((_e1606 + (((_e1066 + (((_e1146 + ((_e1153 - _e1146) * _e1168)) - _e1066) * _e1607)) - _e1606) * _e1612)) * _e1675) + _e1680);
let _e1689 = select(0f, _e1687, (_e1687 > 0f));
let _e1691 = select(1f, _e1689, (_e1689 < 1f));
let _e1693 = (((_e1619 + (((_e1074 + (((_e1160 + ((f32(bitcast<i32>(((_e1139 >> bitcast<u32>((_e1161 & 31u))) & 65535u))) - _e1160) * _e1176)) - _e1074) * _e1620)) - _e1619) * _e1624)) * _e1675) + _e1680);
let _e1695 = select(0f, _e1693, (_e1693 > 0f));
let _e1697 = select(1f, _e1695, (_e1695 < 1f));
let _e1699 = (((_e1631 + (((_e1338 + ((_e1070 - _e1338) * _e1632)) - _e1631) * _e1636)) * _e1675) + _e1680);
let _e1701 = select(0f, _e1699, (_e1699 > 0f));
let _e1703 = select(1f, _e1701, (_e1701 < 1f));
let _e1705 = (((_e1643 + (((_e1175 + (((_e1378 + ((f32(bitcast<i32>(((_e1371 >> bitcast<u32>((_e1379 & 31u))) & 65535u))) - _e1378) * _e1386)) - _e1175) * _e1644)) - _e1643) * _e1648)) * _e1675) + _e1680);
let _e1707 = select(0f, _e1705, (_e1705 > 0f));
let _e1709 = select(1f, _e1707, (_e1707 < 1f));
let _e1711 = (((_e1655 + ((_e1598 - _e1655) * _e1656)) * _e1675) + _e1680);
let _e1713 = select(0f, _e1711, (_e1711 > 0f));
let _e1715 = select(1f, _e1713, (_e1713 < 1f));
let _e1717 = (((_e1602 + (((_e1491 + (((_e1582 + ((f32(bitcast<i32>(((_e1575 >> bitcast<u32>((_e1583 & 31u))) & 65535u))) - _e1582) * _e1590)) - _e1491) * _e1660)) - _e1602) * _e1664)) * _e1675) + _e1680);
let _e1719 = select(0f, _e1717, (_e1717 > 0f));
let _e1721 = select(1f, _e1719, (_e1719 < 1f));
let _e1722 = (_e1685 * 1024f);
let _e1723 = (1024f - 1f);
let _e1725 = select(0f, _e1722, (_e1722 > 0f));
let _e1727 = select(_e1723, _e1725, (_e1725 < _e1723));
let _e1734 = select(0i, select(select(i32(_e1727), i32(-2147483648), (_e1727 < -2147483600f)), 2147483647i, (_e1727 > 2147483500f)), (_e1727 == _e1727));
let _e1738 = (_e1734 - select(0i, 1i, (_e1727 < f32(_e1734))));
let _e1739 = (262147i + _e1738);
let _e1741 = (bitcast<i32>(_e96) - 1i);
let _e1743 = select(_e1741, _e1739, (_e1739 < _e1741));
let _e1749 = global_4.member[bitcast<u32>(select(0i, _e1743, (_e1743 > 0i)))];
let _e1759 = select(_e1741, 262146i, (262146i < _e1741));
let _e1765 = global_4.member[bitcast<u32>(select(0i, _e1759, (_e1759 > 0i)))];
let _e1766 = bitcast<f32>(_e1765);
let _e1767 = (f32((bitcast<i32>((_e1749 & 4095u)) - 2048i)) * _e1766);
let _e1769 = select(_e1741, 262144i, (262144i < _e1741));
let _e1775 = global_4.member[bitcast<u32>(select(0i, _e1769, (_e1769 > 0i)))];
let _e1776 = bitcast<f32>(_e1775);
let _e1778 = select(_e1741, 262145i, (262145i < _e1741));
let _e1784 = global_4.member[bitcast<u32>(select(0i, _e1778, (_e1778 > 0i)))];
let _e1785 = bitcast<f32>(_e1784);
let _e1791 = ((_e1776 + (f32(bitcast<i32>((_e1749 >> bitcast<u32>(12u)))) * _e1785)) + (_e1767 * (_e1722 - f32(_e1738))));
let _e1792 = (_e1767 * 1024f);
if _e626 {
let _e1799 = ((0.5f * (_e1697 - _e1691)) * _e1792);
let _e1800 = ((0.5f * (_e1709 - _e1703)) * _e1792);
let _e1801 = ((0.5f * (_e1721 - _e1715)) * _e1792);
phi_4007_ = type_29(_e1791, vec3<f32>(_e1799, _e1800, _e1801), vec3<f32>((_e1799 * _e1791), (_e1800 * _e1791), (_e1801 * _e1791)));
} else {
let _e1808 = (_e1691 * 1024f);
let _e1810 = select(0f, _e1808, (_e1808 > 0f));
let _e1812 = select(_e1723, _e1810, (_e1810 < _e1723));
let _e1819 = select(0i, select(select(i32(_e1812), i32(-2147483648), (_e1812 < -2147483600f)), 2147483647i, (_e1812 > 2147483500f)), (_e1812 == _e1812));
let _e1823 = (_e1819 - select(0i, 1i, (_e1812 < f32(_e1819))));
let _e1824 = (262147i + _e1823);
let _e1826 = select(_e1741, _e1824, (_e1824 < _e1741));
let _e1832 = global_4.member[bitcast<u32>(select(0i, _e1826, (_e1826 > 0i)))];
let _e1847 = ((_e1776 + (f32(bitcast<i32>((_e1832 >> bitcast<u32>(12u)))) * _e1785)) + ((f32((bitcast<i32>((_e1832 & 4095u)) - 2048i)) * _e1766) * (_e1808 - f32(_e1823))));
let _e1848 = (_e1697 * 1024f);
let _e1850 = select(0f, _e1848, (_e1848 > 0f));
let _e1852 = select(_e1723, _e1850, (_e1850 < _e1723));
let _e1859 = select(0i, select(select(i32(_e1852), i32(-2147483648), (_e1852 < -2147483600f)), 2147483647i, (_e1852 > 2147483500f)), (_e1852 == _e1852));
let _e1863 = (_e1859 - select(0i, 1i, (_e1852 < f32(_e1859))));
let _e1864 = (262147i + _e1863);
let _e1866 = select(_e1741, _e1864, (_e1864 < _e1741));
let _e1872 = global_4.member[bitcast<u32>(select(0i, _e1866, (_e1866 > 0i)))];
let _e1887 = ((_e1776 + (f32(bitcast<i32>((_e1872 >> bitcast<u32>(12u)))) * _e1785)) + ((f32((bitcast<i32>((_e1872 & 4095u)) - 2048i)) * _e1766) * (_e1848 - f32(_e1863))));
let _e1888 = (_e1703 * 1024f);
let _e1890 = select(0f, _e1888, (_e1888 > 0f));
let _e1892 = select(_e1723, _e1890, (_e1890 < _e1723));
let _e1899 = select(0i, select(select(i32(_e1892), i32(-2147483648), (_e1892 < -2147483600f)), 2147483647i, (_e1892 > 2147483500f)), (_e1892 == _e1892));
let _e1903 = (_e1899 - select(0i, 1i, (_e1892 < f32(_e1899))));
let _e1904 = (262147i + _e1903);
let _e1906 = select(_e1741, _e1904, (_e1904 < _e1741));
let _e1912 = global_4.member[bitcast<u32>(select(0i, _e1906, (_e1906 > 0i)))];
let _e1927 = ((_e1776 + (f32(bitcast<i32>((_e1912 >> bitcast<u32>(12u)))) * _e1785)) + ((f32((bitcast<i32>((_e1912 & 4095u)) - 2048i)) * _e1766) * (_e1888 - f32(_e1903))));
let _e1928 = (_e1709 * 1024f);
let _e1930 = select(0f, _e1928, (_e1928 > 0f));
let _e1932 = select(_e1723, _e1930, (_e1930 < _e1723));
let _e1939 = select(0i, select(select(i32(_e1932), i32(-2147483648), (_e1932 < -2147483600f)), 2147483647i, (_e1932 > 2147483500f)), (_e1932 == _e1932));
let _e1943 = (_e1939 - select(0i, 1i, (_e1932 < f32(_e1939))));
let _e1944 = (262147i + _e1943);
let _e1946 = select(_e1741, _e1944, (_e1944 < _e1741));
let _e1952 = global_4.member[bitcast<u32>(select(0i, _e1946, (_e1946 > 0i)))];
let _e1967 = ((_e1776 + (f32(bitcast<i32>((_e1952 >> bitcast<u32>(12u)))) * _e1785)) + ((f32((bitcast<i32>((_e1952 & 4095u)) - 2048i)) * _e1766) * (_e1928 - f32(_e1943))));
let _e1968 = (_e1715 * 1024f);
let _e1970 = select(0f, _e1968, (_e1968 > 0f));
let _e1972 = select(_e1723, _e1970, (_e1970 < _e1723));
let _e1979 = select(0i, select(select(i32(_e1972), i32(-2147483648), (_e1972 < -2147483600f)), 2147483647i, (_e1972 > 2147483500f)), (_e1972 == _e1972));
let _e1983 = (_e1979 - select(0i, 1i, (_e1972 < f32(_e1979))));
let _e1984 = (262147i + _e1983);
let _e1986 = select(_e1741, _e1984, (_e1984 < _e1741));
let _e1992 = global_4.member[bitcast<u32>(select(0i, _e1986, (_e1986 > 0i)))];
let _e2007 = ((_e1776 + (f32(bitcast<i32>((_e1992 >> bitcast<u32>(12u)))) * _e1785)) + ((f32((bitcast<i32>((_e1992 & 4095u)) - 2048i)) * _e1766) * (_e1968 - f32(_e1983))));
let _e2008 = (_e1721 * 1024f);
let _e2010 = select(0f, _e2008, (_e2008 > 0f));
let _e2012 = select(_e1723, _e2010, (_e2010 < _e1723));
let _e2019 = select(0i, select(select(i32(_e2012), i32(-2147483648), (_e2012 < -2147483600f)), 2147483647i, (_e2012 > 2147483500f)), (_e2012 == _e2012));
let _e2023 = (_e2019 - select(0i, 1i, (_e2012 < f32(_e2019))));
let _e2024 = (262147i + _e2023);
let _e2026 = select(_e1741, _e2024, (_e2024 < _e1741));
let _e2032 = global_4.member[bitcast<u32>(select(0i, _e2026, (_e2026 > 0i)))];
let _e2047 = ((_e1776 + (f32(bitcast<i32>((_e2032 >> bitcast<u32>(12u)))) * _e1785)) + ((f32((bitcast<i32>((_e2032 & 4095u)) - 2048i)) * _e1766) * (_e2008 - f32(_e2023))));
let _e2048 = (_e1887 - _e1847);
let _e2050 = (_e1967 - _e1927);
let _e2052 = (_e2047 - _e2007);
phi_4007_ = type_29(_e1791, vec3<f32>((0.5f * _e2048), (0.5f * _e2050), (0.5f * _e2052)), vec3<f32>((0.25f * (_e2048 * (_e1887 + _e1847))), (0.25f * (_e2050 * (_e1967 + _e1927))), (0.25f * (_e2052 * (_e2047 + _e2007)))));
}
let _e2067 = phi_4007_;
let _e2082 = select(0f, 1f, ((((((_e432 >= -0.5f) && (_e432 <= _e454)) && (_e438 >= -0.5f)) && (_e438 <= _e464)) && (_e444 >= -0.5f)) && (_e444 <= _e474)));
let _e2084 = (0.5f * (_e1697 - _e1691));
let _e2086 = (0.5f * (_e1709 - _e1703));
let _e2088 = (0.5f * (_e1721 - _e1715));
let _e2094 = global_1.member.member_6.member.member.member;
let _e2100 = global_1.member.member_6.member.member.member_1;
let _e2106 = global_1.member.member_6.member.member.member_2;
let _e2112 = global_1.member.member_6.member_1.member.member;
let _e2118 = global_1.member.member_6.member_1.member.member_1;
let _e2124 = global_1.member.member_6.member_1.member.member_2;
let _e2130 = global_1.member.member_6.member_2.member.member;
let _e2136 = global_1.member.member_6.member_2.member.member_1;
let _e2142 = global_1.member.member_6.member_2.member.member_2;
phi_4708_ = type_30(_e1685, vec3<f32>(((((_e2094 * _e2084) + (_e2112 * _e2086)) + (_e2130 * _e2088)) * _e2082), ((((_e2100 * _e2084) + (_e2118 * _e2086)) + (_e2136 * _e2088)) * _e2082), ((((_e2106 * _e2084) + (_e2124 * _e2086)) + (_e2142 * _e2088)) * _e2082)), _e2067.member, vec3<f32>(((((_e2094 * _e2067.member_2.x) + (_e2112 * _e2067.member_2.y)) + (_e2130 * _e2067.member_2.z)) * _e2082), ((((_e2100 * _e2067.member_2.x) + (_e2118 * _e2067.member_2.y)) + (_e2136 * _e2067.member_2.z)) * _e2082), ((((_e2106 * _e2067.member_2.x) + (_e2124 * _e2067.member_2.y)) + (_e2142 * _e2067.member_2.z)) * _e2082)), vec3<f32>(((((_e2094 * _e2067.member_1.x) + (_e2112 * _e2067.member_1.y)) + (_e2130 * _e2067.member_1.z)) * _e2082), ((((_e2100 * _e2067.member_1.x) + (_e2118 * _e2067.member_1.y)) + (_e2136 * _e2067.member_1.z)) * _e2082), ((((_e2106 * _e2067.member_1.x) + (_e2124 * _e2067.member_1.y)) + (_e2142 * _e2067.member_1.z)) * _e2082)));
} else {
let _e2208 = select(-1f, _e458, (_e458 > -1f));
let _e2210 = select(_e453, _e2208, (_e2208 < _e453));
let _e2217 = select(0i, select(select(i32(_e2210), i32(-2147483648), (_e2210 < -2147483600f)), 2147483647i, (_e2210 > 2147483500f)), (_e2210 == _e2210));
let _e2221 = (_e2217 - select(0i, 1i, (_e2210 < f32(_e2217))));
let _e2223 = select(-1f, _e468, (_e468 > -1f));
let _e2225 = select(_e463, _e2223, (_e2223 < _e463));
let _e2232 = select(0i, select(select(i32(_e2225), i32(-2147483648), (_e2225 < -2147483600f)), 2147483647i, (_e2225 > 2147483500f)), (_e2225 == _e2225));
let _e2236 = (_e2232 - select(0i, 1i, (_e2225 < f32(_e2232))));
let _e2238 = select(-1f, _e478, (_e478 > -1f));
let _e2240 = select(_e473, _e2238, (_e2238 < _e473));
let _e2247 = select(0i, select(select(i32(_e2240), i32(-2147483648), (_e2240 < -2147483600f)), 2147483647i, (_e2240 > 2147483500f)), (_e2240 == _e2240));
let _e2251 = (_e2247 - select(0i, 1i, (_e2240 < f32(_e2247))));
let _e2255 = global_1.member.member_6.member_7;
let _e2259 = global_1.member.member_6.member_8;
let _e2260 = (_e2221 + 1i);
let _e2261 = (_e2236 + 1i);
let _e2262 = (_e2251 + 1i);
let _e2267 = global_1.member.member_6.member_11.member;
let _e2273 = global_1.member.member_6.member_11.member_1;
let _e2284 = ((_e2260 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2267) * ((_e2261 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2273) * (_e2262 >> bitcast<u32>(4i))))));
let _e2286 = (bitcast<i32>(_e92) - 1i);
let _e2288 = select(_e2286, _e2284, (_e2284 < _e2286));
let _e2294 = global_2.member[bitcast<u32>(select(0i, _e2288, (_e2288 > 0i)))];
let _e2296 = (_e2260 & 15i);
let _e2299 = ((_e2261 & 15i) * _e2255);
let _e2301 = (bitcast<i32>(_e2294) + ((_e2262 & 15i) * _e2259));
let _e2305 = (_e2299 + _e2255);
let _e2307 = (_e2299 + (2i * _e2255));
let _e2308 = (_e2301 + _e2259);
let _e2310 = (_e2301 + (2i * _e2259));
local_2 = type_28(array<i32, 4>(_e2296, (_e2296 + 1i), (_e2296 + 2i), (_e2296 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e458 - f32(_e2221)), (_e468 - f32(_e2236)), (_e478 - f32(_e2251)));
let _e2324 = local_2.member[1u];
let _e2325 = ((_e2308 + _e2305) + _e2324);
let _e2327 = (_e2325 >> bitcast<u32>(1i));
let _e2330 = bitcast<u32>(((_e2325 & 1i) * 16i));
let _e2332 = select(_e2286, _e2327, (_e2327 < _e2286));
let _e2337 = global_2.member[bitcast<u32>(select(0i, _e2332, (_e2332 > 0i)))];
let _e2341 = (_e2327 + 1i);
let _e2343 = select(_e2286, _e2341, (_e2341 < _e2286));
let _e2348 = global_2.member[bitcast<u32>(select(0i, _e2343, (_e2343 > 0i)))];
let _e2355 = ((_e2337 >> bitcast<u32>((_e2330 & 31u))) | ((_e2348 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2330) & 31u))));
let _e2358 = local_2.member_1[2u];
let _e2364 = f32(bitcast<i32>(((_e2355 >> bitcast<u32>((_e2358 & 31u))) & 65535u)));
let _e2367 = local_2.member_1[3u];
let _e2374 = local_3[0u];
let _e2377 = (_e2364 + ((f32(bitcast<i32>(((_e2355 >> bitcast<u32>((_e2367 & 31u))) & 65535u))) - _e2364) * _e2374));
let _e2379 = local_2.member[1u];
let _e2380 = ((_e2308 + _e2307) + _e2379);
let _e2382 = (_e2380 >> bitcast<u32>(1i));
let _e2385 = bitcast<u32>(((_e2380 & 1i) * 16i));
let _e2387 = select(_e2286, _e2382, (_e2382 < _e2286));
let _e2392 = global_2.member[bitcast<u32>(select(0i, _e2387, (_e2387 > 0i)))];
let _e2396 = (_e2382 + 1i);
let _e2398 = select(_e2286, _e2396, (_e2396 < _e2286));
let _e2403 = global_2.member[bitcast<u32>(select(0i, _e2398, (_e2398 > 0i)))];
let _e2410 = ((_e2392 >> bitcast<u32>((_e2385 & 31u))) | ((_e2403 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2385) & 31u))));
let _e2411 = local_2.member_1[2u];
let _e2417 = f32(bitcast<i32>(((_e2410 >> bitcast<u32>((_e2411 & 31u))) & 65535u)));
let _e2418 = local_2.member_1[3u];
let _e2425 = local_3[0u];
let _e2430 = local_3[1u];
let _e2433 = (_e2377 + (((_e2417 + ((f32(bitcast<i32>(((_e2410 >> bitcast<u32>((_e2418 & 31u))) & 65535u))) - _e2417) * _e2425)) - _e2377) * _e2430));
let _e2435 = local_2.member[1u];
let _e2436 = ((_e2310 + _e2305) + _e2435);
let _e2438 = (_e2436 >> bitcast<u32>(1i));
let _e2441 = bitcast<u32>(((_e2436 & 1i) * 16i));
let _e2443 = select(_e2286, _e2438, (_e2438 < _e2286));
let _e2448 = global_2.member[bitcast<u32>(select(0i, _e2443, (_e2443 > 0i)))];
let _e2452 = (_e2438 + 1i);
let _e2454 = select(_e2286, _e2452, (_e2452 < _e2286));
let _e2459 = global_2.member[bitcast<u32>(select(0i, _e2454, (_e2454 > 0i)))];
let _e2466 = ((_e2448 >> bitcast<u32>((_e2441 & 31u))) | ((_e2459 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2441) & 31u))));
let _e2467 = local_2.member_1[2u];
let _e2473 = f32(bitcast<i32>(((_e2466 >> bitcast<u32>((_e2467 & 31u))) & 65535u)));
let _e2474 = local_2.member_1[3u];
let _e2481 = local_3[0u];
let _e2484 = (_e2473 + ((f32(bitcast<i32>(((_e2466 >> bitcast<u32>((_e2474 & 31u))) & 65535u))) - _e2473) * _e2481));
let _e2486 = local_2.member[1u];
let _e2487 = ((_e2310 + _e2307) + _e2486);
let _e2489 = (_e2487 >> bitcast<u32>(1i));
let _e2492 = bitcast<u32>(((_e2487 & 1i) * 16i));
let _e2494 = select(_e2286, _e2489, (_e2489 < _e2286));
let _e2499 = global_2.member[bitcast<u32>(select(0i, _e2494, (_e2494 > 0i)))];
let _e2503 = (_e2489 + 1i);
let _e2505 = select(_e2286, _e2503, (_e2503 < _e2286));
let _e2510 = global_2.member[bitcast<u32>(select(0i, _e2505, (_e2505 > 0i)))];
let _e2517 = ((_e2499 >> bitcast<u32>((_e2492 & 31u))) | ((_e2510 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2492) & 31u))));
let _e2518 = local_2.member_1[2u];
let _e2524 = f32(bitcast<i32>(((_e2517 >> bitcast<u32>((_e2518 & 31u))) & 65535u)));
let _e2525 = local_2.member_1[3u];
let _e2532 = local_3[0u];
let _e2536 = local_3[1u];
let _e2541 = local_3[2u];
let _e2548 = global_1.member.member_6.member_5;
let _e2553 = global_1.member.member_6.member_6;
let _e2554 = (((_e2433 + (((_e2484 + (((_e2524 + ((f32(bitcast<i32>(((_e2517 >> bitcast<u32>((_e2525 & 31u))) & 65535u))) - _e2524) * _e2532)) - _e2484) * _e2536)) - _e2433) * _e2541)) * _e2548) + _e2553);
let _e2556 = select(0f, _e2554, (_e2554 > 0f));
phi_4708_ = type_30(select(1f, _e2556, (_e2556 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2561 = phi_4708_;
let _e2563 = select(-0.5f, _e396, (_e396 > -0.5f));
let _e2565 = select(_e454, _e2563, (_e2563 < _e454));
let _e2567 = select(-0.5f, _e411, (_e411 > -0.5f));
let _e2569 = select(_e464, _e2567, (_e2567 < _e464));
let _e2571 = select(-0.5f, _e426, (_e426 > -0.5f));
let _e2573 = select(_e474, _e2571, (_e2571 < _e474));
let _e2575 = select(-1f, _e2565, (_e2565 > -1f));
let _e2577 = select(_e453, _e2575, (_e2575 < _e453));
let _e2584 = select(0i, select(select(i32(_e2577), i32(-2147483648), (_e2577 < -2147483600f)), 2147483647i, (_e2577 > 2147483500f)), (_e2577 == _e2577));
let _e2588 = (_e2584 - select(0i, 1i, (_e2577 < f32(_e2584))));
let _e2590 = select(-1f, _e2569, (_e2569 > -1f));
let _e2592 = select(_e463, _e2590, (_e2590 < _e463));
let _e2599 = select(0i, select(select(i32(_e2592), i32(-2147483648), (_e2592 < -2147483600f)), 2147483647i, (_e2592 > 2147483500f)), (_e2592 == _e2592));
let _e2603 = (_e2599 - select(0i, 1i, (_e2592 < f32(_e2599))));
let _e2605 = select(-1f, _e2573, (_e2573 > -1f));
let _e2607 = select(_e473, _e2605, (_e2605 < _e473));
let _e2614 = select(0i, select(select(i32(_e2607), i32(-2147483648), (_e2607 < -2147483600f)), 2147483647i, (_e2607 > 2147483500f)), (_e2607 == _e2607));
let _e2618 = (_e2614 - select(0i, 1i, (_e2607 < f32(_e2614))));
let _e2622 = global_1.member.member_6.member_7;
let _e2626 = global_1.member.member_6.member_8;
let _e2627 = (_e2588 + 1i);
let _e2628 = (_e2603 + 1i);
let _e2629 = (_e2618 + 1i);
let _e2634 = global_1.member.member_6.member_11.member;
let _e2640 = global_1.member.member_6.member_11.member_1;
let _e2651 = ((_e2627 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2634) * ((_e2628 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2640) * (_e2629 >> bitcast<u32>(4i))))));
let _e2653 = (bitcast<i32>(_e92) - 1i);
let _e2655 = select(_e2653, _e2651, (_e2651 < _e2653));
let _e2661 = global_2.member[bitcast<u32>(select(0i, _e2655, (_e2655 > 0i)))];
let _e2663 = (_e2627 & 15i);
let _e2666 = ((_e2628 & 15i) * _e2622);
let _e2668 = (bitcast<i32>(_e2661) + ((_e2629 & 15i) * _e2626));
let _e2672 = (_e2666 + _e2622);
let _e2674 = (_e2666 + (2i * _e2622));
let _e2675 = (_e2668 + _e2626);
let _e2677 = (_e2668 + (2i * _e2626));
local = type_28(array<i32, 4>(_e2663, (_e2663 + 1i), (_e2663 + 2i), (_e2663 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2565 - f32(_e2588)), (_e2569 - f32(_e2603)), (_e2573 - f32(_e2618)));
let _e2691 = local.member[1u];
let _e2692 = ((_e2675 + _e2672) + _e2691);
let _e2694 = (_e2692 >> bitcast<u32>(1i));
let _e2697 = bitcast<u32>(((_e2692 & 1i) * 16i));
let _e2699 = select(_e2653, _e2694, (_e2694 < _e2653));
let _e2704 = global_2.member[bitcast<u32>(select(0i, _e2699, (_e2699 > 0i)))];
let _e2708 = (_e2694 + 1i);
let _e2710 = select(_e2653, _e2708, (_e2708 < _e2653));
let _e2715 = global_2.member[bitcast<u32>(select(0i, _e2710, (_e2710 > 0i)))];
let _e2722 = ((_e2704 >> bitcast<u32>((_e2697 & 31u))) | ((_e2715 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2697) & 31u))));
let _e2725 = local.member_1[2u];
let _e2731 = f32(bitcast<i32>(((_e2722 >> bitcast<u32>((_e2725 & 31u))) & 65535u)));
let _e2734 = local.member_1[3u];
let _e2741 = local_1[0u];
let _e2744 = (_e2731 + ((f32(bitcast<i32>(((_e2722 >> bitcast<u32>((_e2734 & 31u))) & 65535u))) - _e2731) * _e2741));
let _e2746 = local.member[1u];
let _e2747 = ((_e2675 + _e2674) + _e2746);
let _e2749 = (_e2747 >> bitcast<u32>(1i));
let _e2752 = bitcast<u32>(((_e2747 & 1i) * 16i));
let _e2754 = select(_e2653, _e2749, (_e2749 < _e2653));
let _e2759 = global_2.member[bitcast<u32>(select(0i, _e2754, (_e2754 > 0i)))];
let _e2763 = (_e2749 + 1i);
let _e2765 = select(_e2653, _e2763, (_e2763 < _e2653));
let _e2770 = global_2.member[bitcast<u32>(select(0i, _e2765, (_e2765 > 0i)))];
let _e2777 = ((_e2759 >> bitcast<u32>((_e2752 & 31u))) | ((_e2770 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2752) & 31u))));
let _e2778 = local.member_1[2u];
let _e2784 = f32(bitcast<i32>(((_e2777 >> bitcast<u32>((_e2778 & 31u))) & 65535u)));
let _e2785 = local.member_1[3u];
let _e2792 = local_1[0u];
let _e2797 = local_1[1u];
let _e2800 = (_e2744 + (((_e2784 + ((f32(bitcast<i32>(((_e2777 >> bitcast<u32>((_e2785 & 31u))) & 65535u))) - _e2784) * _e2792)) - _e2744) * _e2797));
let _e2802 = local.member[1u];
let _e2803 = ((_e2677 + _e2672) + _e2802);
let _e2805 = (_e2803 >> bitcast<u32>(1i));
let _e2808 = bitcast<u32>(((_e2803 & 1i) * 16i));
let _e2810 = select(_e2653, _e2805, (_e2805 < _e2653));
let _e2815 = global_2.member[bitcast<u32>(select(0i, _e2810, (_e2810 > 0i)))];
let _e2819 = (_e2805 + 1i);
let _e2821 = select(_e2653, _e2819, (_e2819 < _e2653));
let _e2826 = global_2.member[bitcast<u32>(select(0i, _e2821, (_e2821 > 0i)))];
let _e2833 = ((_e2815 >> bitcast<u32>((_e2808 & 31u))) | ((_e2826 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2808) & 31u))));
let _e2834 = local.member_1[2u];
let _e2840 = f32(bitcast<i32>(((_e2833 >> bitcast<u32>((_e2834 & 31u))) & 65535u)));
let _e2841 = local.member_1[3u];
let _e2848 = local_1[0u];
let _e2851 = (_e2840 + ((f32(bitcast<i32>(((_e2833 >> bitcast<u32>((_e2841 & 31u))) & 65535u))) - _e2840) * _e2848));
let _e2853 = local.member[1u];
let _e2854 = ((_e2677 + _e2674) + _e2853);
let _e2856 = (_e2854 >> bitcast<u32>(1i));
let _e2859 = bitcast<u32>(((_e2854 & 1i) * 16i));
let _e2861 = select(_e2653, _e2856, (_e2856 < _e2653));
let _e2866 = global_2.member[bitcast<u32>(select(0i, _e2861, (_e2861 > 0i)))];
let _e2870 = (_e2856 + 1i);
let _e2872 = select(_e2653, _e2870, (_e2870 < _e2653));
let _e2877 = global_2.member[bitcast<u32>(select(0i, _e2872, (_e2872 > 0i)))];
let _e2884 = ((_e2866 >> bitcast<u32>((_e2859 & 31u))) | ((_e2877 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2859) & 31u))));
let _e2885 = local.member_1[2u];
let _e2891 = f32(bitcast<i32>(((_e2884 >> bitcast<u32>((_e2885 & 31u))) & 65535u)));
let _e2892 = local.member_1[3u];
let _e2899 = local_1[0u];
let _e2903 = local_1[1u];
let _e2908 = local_1[2u];
let _e2915 = global_1.member.member_6.member_5;
let _e2920 = global_1.member.member_6.member_6;
let _e2921 = (((_e2800 + (((_e2851 + (((_e2891 + ((f32(bitcast<i32>(((_e2884 >> bitcast<u32>((_e2892 & 31u))) & 65535u))) - _e2891) * _e2899)) - _e2851) * _e2903)) - _e2800) * _e2908)) * _e2915) + _e2920);
let _e2923 = select(0f, _e2921, (_e2921 > 0f));
if ((_e612 & 16u) == 0u) {
phi_5632_ = type_5(1f, 1f, 1f);
} else {
let _e2931 = global_1.member.member_14.member;
let _e2942 = ((((_e2931.member.member * _e307) + (_e2931.member.member_1 * _e316)) + (_e2931.member.member_2 * _e289)) + _e2931.member_1);
let _e2948 = ((((_e2931.member.member * _e328) + (_e2931.member.member_1 * _e333)) + (_e2931.member.member_2 * _e322)) + _e2931.member_1);
let _e2950 = select(_e2948, _e2942, (_e2942 < _e2948));
let _e2952 = select(_e2948, _e2942, (_e2942 > _e2948));
let _e2954 = (_e2952 - _e2950);
let _e2957 = (-(_e2950) / select(1e-30f, _e2954, (_e2954 > 1e-30f)));
let _e2959 = select(0f, _e2957, (_e2957 > 0f));
let _e2965 = select(select(select(1f, _e2959, (_e2959 < 1f)), 1f, (_e2952 <= 0f)), 0f, (_e2950 > 0f));
let _e2970 = global_1.member.member_14.member_1;
let _e2971 = (_e2970 != 0u);
let _e2981 = global_1.member.member_15.member;
let _e2992 = ((((_e2981.member.member * _e307) + (_e2981.member.member_1 * _e316)) + (_e2981.member.member_2 * _e289)) + _e2981.member_1);
let _e2998 = ((((_e2981.member.member * _e328) + (_e2981.member.member_1 * _e333)) + (_e2981.member.member_2 * _e322)) + _e2981.member_1);
let _e3000 = select(_e2998, _e2992, (_e2992 < _e2998));
let _e3002 = select(_e2998, _e2992, (_e2992 > _e2998));
let _e3004 = (_e3002 - _e3000);
let _e3007 = (-(_e3000) / select(1e-30f, _e3004, (_e3004 > 1e-30f)));
let _e3009 = select(0f, _e3007, (_e3007 > 0f));
let _e3015 = select(select(select(1f, _e3009, (_e3009 < 1f)), 1f, (_e3002 <= 0f)), 0f, (_e3000 > 0f));
let _e3020 = global_1.member.member_15.member_1;
let _e3021 = (_e3020 != 0u);
let _e3031 = global_1.member.member_16.member;
let _e3042 = ((((_e3031.member.member * _e307) + (_e3031.member.member_1 * _e316)) + (_e3031.member.member_2 * _e289)) + _e3031.member_1);
let _e3048 = ((((_e3031.member.member * _e328) + (_e3031.member.member_1 * _e333)) + (_e3031.member.member_2 * _e322)) + _e3031.member_1);
let _e3050 = select(_e3048, _e3042, (_e3042 < _e3048));
let _e3052 = select(_e3048, _e3042, (_e3042 > _e3048));
let _e3054 = (_e3052 - _e3050);
let _e3057 = (-(_e3050) / select(1e-30f, _e3054, (_e3054 > 1e-30f)));
let _e3059 = select(0f, _e3057, (_e3057 > 0f));
let _e3065 = select(select(select(1f, _e3059, (_e3059 < 1f)), 1f, (_e3052 <= 0f)), 0f, (_e3050 > 0f));
let _e3070 = global_1.member.member_16.member_1;
let _e3071 = (_e3070 != 0u);
let _e3081 = global_1.member.member_17.member;
let _e3092 = ((((_e3081.member.member * _e307) + (_e3081.member.member_1 * _e316)) + (_e3081.member.member_2 * _e289)) + _e3081.member_1);
let _e3098 = ((((_e3081.member.member * _e328) + (_e3081.member.member_1 * _e333)) + (_e3081.member.member_2 * _e322)) + _e3081.member_1);
let _e3100 = select(_e3098, _e3092, (_e3092 < _e3098));
let _e3102 = select(_e3098, _e3092, (_e3092 > _e3098));
let _e3104 = (_e3102 - _e3100);
let _e3107 = (-(_e3100) / select(1e-30f, _e3104, (_e3104 > 1e-30f)));
let _e3109 = select(0f, _e3107, (_e3107 > 0f));
let _e3115 = select(select(select(1f, _e3109, (_e3109 < 1f)), 1f, (_e3102 <= 0f)), 0f, (_e3100 > 0f));
let _e3120 = global_1.member.member_17.member_1;
let _e3121 = (_e3120 != 0u);
phi_5632_ = type_5(((((1f * _e2965) * _e3015) * _e3065) * _e3115), ((((1f * select(1f, _e2965, _e2971)) * select(1f, _e3015, _e3021)) * select(1f, _e3065, _e3071)) * select(1f, _e3115, _e3121)), ((((1f * select(1f, 0f, (_e2971 && (_e2948 > 0f)))) * select(1f, 0f, (_e3021 && (_e2998 > 0f)))) * select(1f, 0f, (_e3071 && (_e3048 > 0f)))) * select(1f, 0f, (_e3121 && (_e3098 > 0f)))));
}
let _e3130 = phi_5632_;
let _e3131 = (_e328 - _e307);
let _e3132 = (_e333 - _e316);
let _e3133 = (_e322 - _e289);
let _e3138 = (((_e3131 * _e3131) + (_e3132 * _e3132)) + (_e3133 * _e3133));
let _e3142 = (_e484 < 1e-12f);
let _e3144 = (1f / select(_e479, 1f, _e3142));
let _e3146 = ((-0.5f - _e396) * _e3144);
let _e3148 = ((_e454 - _e396) * _e3144);
let _e3154 = select(_e3148, _e3146, (_e3146 < _e3148));
let _e3156 = select(0f, _e3154, (_e3154 > 0f));
let _e3159 = select(select(1f, _e3156, (_e3156 < 1f)), select(2f, 0f, ((_e396 >= -0.5f) && (_e396 <= _e454))), _e3142);
let _e3161 = select(_e3148, _e3146, (_e3146 > _e3148));
let _e3163 = select(0f, _e3161, (_e3161 > 0f));
let _e3166 = select(select(1f, _e3163, (_e3163 < 1f)), 1f, _e3142);
let _e3167 = (_e487 < 1e-12f);
let _e3169 = (1f / select(_e480, 1f, _e3167));
let _e3171 = ((-0.5f - _e411) * _e3169);
let _e3173 = ((_e464 - _e411) * _e3169);
let _e3179 = select(_e3173, _e3171, (_e3171 < _e3173));
let _e3181 = select(0f, _e3179, (_e3179 > 0f));
let _e3184 = select(select(1f, _e3181, (_e3181 < 1f)), select(2f, 0f, ((_e411 >= -0.5f) && (_e411 <= _e464))), _e3167);
let _e3186 = select(_e3173, _e3171, (_e3171 > _e3173));
let _e3188 = select(0f, _e3186, (_e3186 > 0f));
let _e3191 = select(select(1f, _e3188, (_e3188 < 1f)), 1f, _e3167);
let _e3192 = (_e492 < 1e-12f);
let _e3194 = (1f / select(_e481, 1f, _e3192));
let _e3196 = ((-0.5f - _e426) * _e3194);
let _e3198 = ((_e474 - _e426) * _e3194);
let _e3204 = select(_e3198, _e3196, (_e3196 < _e3198));
let _e3206 = select(0f, _e3204, (_e3204 > 0f));
let _e3209 = select(select(1f, _e3206, (_e3206 < 1f)), select(2f, 0f, ((_e426 >= -0.5f) && (_e426 <= _e474))), _e3192);
let _e3211 = select(_e3198, _e3196, (_e3196 > _e3198));
let _e3213 = select(0f, _e3211, (_e3211 > 0f));
let _e3216 = select(select(1f, _e3213, (_e3213 < 1f)), 1f, _e3192);
let _e3218 = select(_e3191, _e3166, (_e3166 < _e3191));
let _e3222 = select(_e3184, _e3159, (_e3159 > _e3184));
let _e3225 = (select(_e3216, _e3218, (_e3218 < _e3216)) - select(_e3209, _e3222, (_e3222 > _e3209)));
let _e3232 = global_1.member.member_5.member_3;
let _e3233 = ((sqrt(select(0f, _e3138, (_e3138 > 0f))) * select(0f, _e3225, (_e3225 > 0f))) * _e3232);
let _e3235 = (select(1f, _e2923, (_e2923 < 1f)) * 255f);
let _e3236 = (_e2561.member * 255f);
let _e3237 = (255f - 1f);
let _e3239 = select(0f, _e3235, (_e3235 > 0f));
let _e3241 = select(_e3237, _e3239, (_e3239 < _e3237));
let _e3248 = select(0i, select(select(i32(_e3241), i32(-2147483648), (_e3241 < -2147483600f)), 2147483647i, (_e3241 > 2147483500f)), (_e3241 == _e3241));
let _e3252 = (_e3248 - select(0i, 1i, (_e3241 < f32(_e3248))));
let _e3254 = select(0f, _e3236, (_e3236 > 0f));
let _e3256 = select(_e3237, _e3254, (_e3254 < _e3237));
let _e3263 = select(0i, select(select(i32(_e3256), i32(-2147483648), (_e3256 < -2147483600f)), 2147483647i, (_e3256 > 2147483500f)), (_e3256 == _e3256));
let _e3267 = (_e3263 - select(0i, 1i, (_e3256 < f32(_e3263))));
let _e3270 = (((_e3252 * 256i) + _e3267) * 4i);
let _e3272 = (_e3235 - f32(_e3252));
let _e3274 = (_e3236 - f32(_e3267));
let _e3276 = (bitcast<i32>(_e96) - 1i);
let _e3278 = select(_e3276, _e3270, (_e3270 < _e3276));
let _e3284 = global_4.member[bitcast<u32>(select(0i, _e3278, (_e3278 > 0i)))];
let _e3285 = (_e3270 + 4i);
let _e3287 = select(_e3276, _e3285, (_e3285 < _e3276));
let _e3293 = global_4.member[bitcast<u32>(select(0i, _e3287, (_e3287 > 0i)))];
let _e3294 = (_e3270 + 1024i);
let _e3296 = select(_e3276, _e3294, (_e3294 < _e3276));
let _e3302 = global_4.member[bitcast<u32>(select(0i, _e3296, (_e3296 > 0i)))];
let _e3303 = (_e3270 + 1028i);
let _e3305 = select(_e3276, _e3303, (_e3303 < _e3276));
let _e3311 = global_4.member[bitcast<u32>(select(0i, _e3305, (_e3305 > 0i)))];
let _e3316 = (bitcast<f32>(((_e3284 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3324 = (_e3316 + (((bitcast<f32>(((_e3293 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3316) * _e3274));
let _e3329 = (bitcast<f32>(((_e3302 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3353 = (bitcast<f32>((((_e3284 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3361 = (_e3353 + (((bitcast<f32>((((_e3293 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3353) * _e3274));
let _e3366 = (bitcast<f32>((((_e3302 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3378 = (_e3270 + 1i);
let _e3380 = select(_e3276, _e3378, (_e3378 < _e3276));
let _e3386 = global_4.member[bitcast<u32>(select(0i, _e3380, (_e3380 > 0i)))];
let _e3387 = (_e3270 + 5i);
let _e3389 = select(_e3276, _e3387, (_e3387 < _e3276));
let _e3395 = global_4.member[bitcast<u32>(select(0i, _e3389, (_e3389 > 0i)))];
let _e3396 = (_e3270 + 1025i);
let _e3398 = select(_e3276, _e3396, (_e3396 < _e3276));
let _e3404 = global_4.member[bitcast<u32>(select(0i, _e3398, (_e3398 > 0i)))];
let _e3405 = (_e3270 + 1029i);
let _e3407 = select(_e3276, _e3405, (_e3405 < _e3276));
let _e3413 = global_4.member[bitcast<u32>(select(0i, _e3407, (_e3407 > 0i)))];
let _e3418 = (bitcast<f32>(((_e3386 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3426 = (_e3418 + (((bitcast<f32>(((_e3395 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3418) * _e3274));
let _e3431 = (bitcast<f32>(((_e3404 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3455 = (bitcast<f32>((((_e3386 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3463 = (_e3455 + (((bitcast<f32>((((_e3395 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3455) * _e3274));
let _e3468 = (bitcast<f32>((((_e3404 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3483 = (_e3233 * _e3130.member_1);
let _e3485 = -(((_e3361 + (((_e3366 + (((bitcast<f32>((((_e3311 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3366) * _e3274)) - _e3361) * _e3272)) * _e3483));
let _e3487 = select(-87f, _e3485, (_e3485 > -87f));
let _e3489 = select(88f, _e3487, (_e3487 < 88f));
let _e3491 = ((_e3489 * 1.442695f) + 0.5f);
let _e3493 = select(-127f, _e3491, (_e3491 > -127f));
let _e3495 = select(128f, _e3493, (_e3493 < 128f));
let _e3502 = select(0i, select(select(i32(_e3495), i32(-2147483648), (_e3495 < -2147483600f)), 2147483647i, (_e3495 > 2147483500f)), (_e3495 == _e3495));
let _e3506 = (_e3502 - select(0i, 1i, (_e3495 < f32(_e3502))));
let _e3507 = f32(_e3506);
let _e3511 = ((_e3489 - (_e3507 * 0.6933594f)) - (_e3507 * -2.1219444e-4f));
let _e3533 = -(((_e3426 + (((_e3431 + (((bitcast<f32>(((_e3413 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3431) * _e3274)) - _e3426) * _e3272)) * _e3483));
let _e3535 = select(-87f, _e3533, (_e3533 > -87f));
let _e3537 = select(88f, _e3535, (_e3535 < 88f));
let _e3539 = ((_e3537 * 1.442695f) + 0.5f);
let _e3541 = select(-127f, _e3539, (_e3539 > -127f));
let _e3543 = select(128f, _e3541, (_e3541 < 128f));
let _e3550 = select(0i, select(select(i32(_e3543), i32(-2147483648), (_e3543 < -2147483600f)), 2147483647i, (_e3543 > 2147483500f)), (_e3543 == _e3543));
let _e3554 = (_e3550 - select(0i, 1i, (_e3543 < f32(_e3550))));
let _e3555 = f32(_e3554);
let _e3559 = ((_e3537 - (_e3555 * 0.6933594f)) - (_e3555 * -2.1219444e-4f));
let _e3581 = -(((_e3463 + (((_e3468 + (((bitcast<f32>((((_e3413 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3468) * _e3274)) - _e3463) * _e3272)) * _e3483));
let _e3583 = select(-87f, _e3581, (_e3581 > -87f));
let _e3585 = select(88f, _e3583, (_e3583 < 88f));
let _e3587 = ((_e3585 * 1.442695f) + 0.5f);
let _e3589 = select(-127f, _e3587, (_e3587 > -127f));
let _e3591 = select(128f, _e3589, (_e3589 < 128f));
let _e3598 = select(0i, select(select(i32(_e3591), i32(-2147483648), (_e3591 < -2147483600f)), 2147483647i, (_e3591 > 2147483500f)), (_e3591 == _e3591));
let _e3602 = (_e3598 - select(0i, 1i, (_e3591 < f32(_e3598))));
let _e3603 = f32(_e3602);
let _e3607 = ((_e3585 - (_e3603 * 0.6933594f)) - (_e3603 * -2.1219444e-4f));
let _e3629 = -(((_e3324 + (((_e3329 + (((bitcast<f32>(((_e3311 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3329) * _e3274)) - _e3324) * _e3272)) * (_e3233 * _e3130.member)));
let _e3631 = select(-87f, _e3629, (_e3629 > -87f));
let _e3633 = select(88f, _e3631, (_e3631 < 88f));
let _e3635 = ((_e3633 * 1.442695f) + 0.5f);
let _e3637 = select(-127f, _e3635, (_e3635 > -127f));
let _e3639 = select(128f, _e3637, (_e3637 < 128f));
let _e3646 = select(0i, select(select(i32(_e3639), i32(-2147483648), (_e3639 < -2147483600f)), 2147483647i, (_e3639 > 2147483500f)), (_e3639 == _e3639));
let _e3650 = (_e3646 - select(0i, 1i, (_e3639 < f32(_e3646))));
let _e3651 = f32(_e3650);
let _e3655 = ((_e3633 - (_e3651 * 0.6933594f)) - (_e3651 * -2.1219444e-4f));
let _e3675 = ((1f + (_e3655 * (1f + (_e3655 * (0.5f + (_e3655 * (0.16666667f + (_e3655 * (0.041666668f + (_e3655 * (0.008333334f + (_e3655 * (0.001388889f + (_e3655 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3650 + 127i)) << bitcast<u32>(23i))));
if _e629 {
let _e3690 = global_1.member.member_5.member_4;
let _e3693 = (_e2561.member_3.x * _e3130.member_2);
let _e3695 = (_e2561.member_3.y * _e3130.member_2);
let _e3697 = (_e2561.member_3.z * _e3130.member_2);
let _e3698 = (0.5f * (_e246 / _e197));
let _e3702 = (_e175 + (_e3693 * _e3698));
let _e3703 = (_e186 + (_e3695 * _e3698));
let _e3704 = (_e197 + (_e3697 * _e3698));
let _e3706 = (2f * _e246);
let _e3708 = ((_e3704 * _e3704) + (_e3706 * _e3697));
let _e3712 = (_e3704 + sqrt(select(0f, _e3708, (_e3708 > 0f))));
let _e3716 = (0.5f * (_e3706 / select(1e-6f, _e3712, (_e3712 > 1e-6f))));
let _e3720 = (_e3702 + (_e3693 * _e3716));
let _e3721 = (_e3703 + (_e3695 * _e3716));
let _e3722 = (_e3704 + (_e3697 * _e3716));
let _e3726 = (_e3690 * _e3690);
let _e3728 = (_e3722 * _e3722);
let _e3736 = (((_e3704 <= 0f) || (_e3708 <= 0f)) || ((_e3722 <= 0f) || (_e3728 <= (_e3726 * (((_e3720 * _e3720) + (_e3721 * _e3721)) + _e3728)))));
let _e3750 = (_e175 + ((_e2561.member_4.x * _e3130.member_2) * _e246));
let _e3751 = (_e186 + ((_e2561.member_4.y * _e3130.member_2) * _e246));
let _e3752 = (_e197 + ((_e2561.member_4.z * _e3130.member_2) * _e246));
let _e3754 = (_e3752 * _e3752);
let _e3763 = ((_e612 & 1u) != 0u);
phi_6658_ = vec3<f32>(select(select(select(_e3720, _e3702, _e3736), _e3750, _e3763), _e175, _e619), select(select(select(_e3721, _e3703, _e3736), _e3751, _e3763), _e186, _e619), select(select(select(_e3722, _e3704, _e3736), _e3752, _e3763), _e197, _e619));
phi_6659_ = (select(_e3736, ((_e3752 <= 0f) || (_e3754 <= (_e3726 * (((_e3750 * _e3750) + (_e3751 * _e3751)) + _e3754)))), _e3763) && !(_e619));
} else {
phi_6658_ = vec3<f32>(_e175, _e186, _e197);
phi_6659_ = false;
}
let _e3775 = phi_6658_;
let _e3777 = phi_6659_;
global_6.member[_e121] = (_e132 + _e261);
global_6.member[_e133] = (_e142 + _e268);
global_6.member[_e144] = (_e153 + _e370);
global_6.member[_e155] = (_e164 + _e373);
global_6.member[_e166] = _e3775.x;
global_6.member[_e177] = _e3775.y;
global_6.member[_e188] = _e3775.z;
global_6.member[_e199] = select((_e208 * (((1f + (_e3511 * (1f + (_e3511 * (0.5f + (_e3511 * (0.16666667f + (_e3511 * (0.041666668f + (_e3511 * (0.008333334f + (_e3511 * (0.001388889f + (_e3511 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3506 + 127i)) << bitcast<u32>(23i)))) * _e3675)), _e208, _e619);
global_6.member[_e210] = select((_e219 * (((1f + (_e3559 * (1f + (_e3559 * (0.5f + (_e3559 * (0.16666667f + (_e3559 * (0.041666668f + (_e3559 * (0.008333334f + (_e3559 * (0.001388889f + (_e3559 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3554 + 127i)) << bitcast<u32>(23i)))) * _e3675)), _e219, _e619);
global_6.member[_e221] = select((_e230 * (((1f + (_e3607 * (1f + (_e3607 * (0.5f + (_e3607 * (0.16666667f + (_e3607 * (0.041666668f + (_e3607 * (0.008333334f + (_e3607 * (0.001388889f + (_e3607 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3602 + 127i)) << bitcast<u32>(23i)))) * _e3675)), _e230, _e619);
global_6.member[_e232] = select(_e241, 1f, _e3777);
}
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
