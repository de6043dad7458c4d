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
var phi_3695_: type_29;
var phi_4341_: type_30;
var phi_5210_: type_5;
var phi_6234_: f32;
var phi_6235_: f32;
var phi_6236_: f32;
var phi_6237_: bool;
switch bitcast<i32>(0u) {
default: {
let _e86 = global;
let _e89 = arrayLength((&global_2.member));
let _e93 = arrayLength((&global_4.member));
let _e100 = global_1.member.member_2;
let _e103 = global_1.member.member;
let _e111 = (_e86.x + _e100.member);
let _e113 = (_e86.y + _e100.member_1);
if (_e111 < _e100.member_2) {
if (_e113 < _e100.member_3) {
let _e116 = (_e103.member * _e103.member_1);
let _e118 = ((_e113 * _e103.member) + _e111);
let _e119 = bitcast<i32>(_e118);
let _e121 = (bitcast<i32>(arrayLength((&global_6.member))) - 1i);
let _e123 = select(_e121, _e119, (_e119 < _e121));
let _e129 = global_6.member[bitcast<u32>(select(0i, _e123, (_e123 > 0i)))];
let _e130 = (_e116 + _e118);
let _e131 = bitcast<i32>(_e130);
let _e133 = select(_e121, _e131, (_e131 < _e121));
let _e139 = global_6.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e141 = ((2u * _e116) + _e118);
let _e142 = bitcast<i32>(_e141);
let _e144 = select(_e121, _e142, (_e142 < _e121));
let _e150 = global_6.member[bitcast<u32>(select(0i, _e144, (_e144 > 0i)))];
let _e152 = ((3u * _e116) + _e118);
let _e153 = bitcast<i32>(_e152);
let _e155 = select(_e121, _e153, (_e153 < _e121));
let _e161 = global_6.member[bitcast<u32>(select(0i, _e155, (_e155 > 0i)))];
let _e163 = ((4u * _e116) + _e118);
let _e164 = bitcast<i32>(_e163);
let _e166 = select(_e121, _e164, (_e164 < _e121));
let _e172 = global_6.member[bitcast<u32>(select(0i, _e166, (_e166 > 0i)))];
let _e174 = ((5u * _e116) + _e118);
let _e175 = bitcast<i32>(_e174);
let _e177 = select(_e121, _e175, (_e175 < _e121));
let _e183 = global_6.member[bitcast<u32>(select(0i, _e177, (_e177 > 0i)))];
let _e185 = ((6u * _e116) + _e118);
let _e186 = bitcast<i32>(_e185);
let _e188 = select(_e121, _e186, (_e186 < _e121));
let _e194 = global_6.member[bitcast<u32>(select(0i, _e188, (_e188 > 0i)))];
let _e196 = ((7u * _e116) + _e118);
let _e197 = bitcast<i32>(_e196);
let _e199 = select(_e121, _e197, (_e197 < _e121));
let _e205 = global_6.member[bitcast<u32>(select(0i, _e199, (_e199 > 0i)))];
let _e207 = ((8u * _e116) + _e118);
let _e208 = bitcast<i32>(_e207);
let _e210 = select(_e121, _e208, (_e208 < _e121));
let _e216 = global_6.member[bitcast<u32>(select(0i, _e210, (_e210 > 0i)))];
let _e218 = ((9u * _e116) + _e118);
let _e219 = bitcast<i32>(_e218);
let _e221 = select(_e121, _e219, (_e219 < _e121));
let _e227 = global_6.member[bitcast<u32>(select(0i, _e221, (_e221 > 0i)))];
let _e229 = ((10u * _e116) + _e118);
let _e230 = bitcast<i32>(_e229);
let _e232 = select(_e121, _e230, (_e230 < _e121));
let _e238 = global_6.member[bitcast<u32>(select(0i, _e232, (_e232 > 0i)))];
let _e242 = global_1.member.member_5.member_2;
let _e245 = (1f / select(1e-6f, _e194, (_e194 > 1e-6f)));
let _e249 = global_1.member.member_8.member_5;
let _e250 = (_e242 * _e249);
let _e255 = global_1.member.member_8.member_6;
let _e257 = (((_e172 * _e245) - _e255) * _e250);
let _e262 = global_1.member.member_8.member_7;
let _e264 = (((_e183 * _e245) - _e262) * _e250);
let _e268 = ((f32(bitcast<i32>(_e111)) - 0.5f) + _e129);
let _e272 = global_1.member.member_8.member_1;
let _e273 = (_e272 + 1u);
let _e275 = select(1u, _e273, (_e273 > 0u));
let _e276 = (_e275 == 0u);
if _e276 {
break;
}
let _e281 = ((f32(bitcast<i32>((_e113 % _e275))) - 0.5f) + _e139);
let _e285 = global_1.member.member_5.member;
let _e289 = global_1.member.member_8.member_8;
let _e290 = (_e285 - _e289);
let _e294 = global_1.member.member_8.member_2;
let _e301 = global_1.member.member_8.member_4;
let _e303 = ((_e294 + (_e255 * _e290)) + ((_e268 + 0.5f) * _e301));
let _e307 = global_1.member.member_8.member_3;
let _e312 = ((_e307 + (_e262 * _e290)) + ((_e281 + 0.5f) * _e301));
let _e318 = global_1.member.member_5.member_1;
let _e319 = (_e318 - _e289);
let _e324 = ((_e294 + (_e255 * _e319)) + (((_e268 + _e257) + 0.5f) * _e301));
let _e329 = ((_e307 + (_e262 * _e319)) + (((_e281 + _e264) + 0.5f) * _e301));
if _e276 {
break;
}
let _e332 = bitcast<i32>(((_e113 / _e275) * 3u));
let _e334 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e336 = select(_e334, _e332, (_e332 < _e334));
let _e342 = global_5.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e343 = (_e332 + 1i);
let _e345 = select(_e334, _e343, (_e343 < _e334));
let _e351 = global_5.member[bitcast<u32>(select(0i, _e345, (_e345 > 0i)))];
let _e352 = (_e332 + 2i);
let _e354 = select(_e334, _e352, (_e352 < _e334));
let _e360 = global_5.member[bitcast<u32>(select(0i, _e354, (_e354 > 0i)))];
let _e363 = (1f / select(1e-6f, _e360, (_e360 > 1e-6f)));
let _e366 = (((_e342 * _e363) - _e255) * _e250);
let _e369 = (((_e351 * _e363) - _e262) * _e250);
let _e381 = global_1.member.member_6.member;
let _e392 = ((((_e381.member.member * _e303) + (_e381.member.member_1 * _e312)) + (_e381.member.member_2 * _e285)) + _e381.member_1);
let _e396 = global_1.member.member_6.member_1;
let _e407 = ((((_e396.member.member * _e303) + (_e396.member.member_1 * _e312)) + (_e396.member.member_2 * _e285)) + _e396.member_1);
let _e411 = global_1.member.member_6.member_2;
let _e422 = ((((_e411.member.member * _e303) + (_e411.member.member_1 * _e312)) + (_e411.member.member_2 * _e285)) + _e411.member_1);
let _e428 = ((((_e381.member.member * _e324) + (_e381.member.member_1 * _e329)) + (_e381.member.member_2 * _e318)) + _e381.member_1);
let _e434 = ((((_e396.member.member * _e324) + (_e396.member.member_1 * _e329)) + (_e396.member.member_2 * _e318)) + _e396.member_1);
let _e440 = ((((_e411.member.member * _e324) + (_e411.member.member_1 * _e329)) + (_e411.member.member_2 * _e318)) + _e411.member_1);
let _e444 = global_1.member.member_6.member_4;
let _e449 = global_1.member.member_6.member_3.member;
let _e450 = (_e449 - 0.5f);
let _e452 = select(-0.5f, _e428, (_e428 > -0.5f));
let _e454 = select(_e450, _e452, (_e452 < _e450));
let _e459 = global_1.member.member_6.member_3.member_1;
let _e460 = (_e459 - 0.5f);
let _e462 = select(-0.5f, _e434, (_e434 > -0.5f));
let _e464 = select(_e460, _e462, (_e462 < _e460));
let _e469 = global_1.member.member_6.member_3.member_2;
let _e470 = (_e469 - 0.5f);
let _e472 = select(-0.5f, _e440, (_e440 > -0.5f));
let _e474 = select(_e470, _e472, (_e472 < _e470));
let _e475 = (_e428 - _e392);
let _e476 = (_e434 - _e407);
let _e477 = (_e440 - _e422);
let _e480 = bitcast<f32>((bitcast<u32>(_e475) & 2147483647u));
let _e483 = bitcast<f32>((bitcast<u32>(_e476) & 2147483647u));
let _e485 = select(_e483, _e480, (_e480 > _e483));
let _e488 = bitcast<f32>((bitcast<u32>(_e477) & 2147483647u));
let _e497 = bitcast<f32>((bitcast<u32>((_e428 - _e454)) & 2147483647u));
let _e500 = bitcast<f32>((bitcast<u32>((_e434 - _e464)) & 2147483647u));
let _e502 = select(_e500, _e497, (_e497 > _e500));
let _e505 = bitcast<f32>((bitcast<u32>((_e440 - _e474)) & 2147483647u));
let _e509 = (_e454 + 0.5f);
let _e510 = (_e449 - 1f);
let _e512 = select(0f, _e509, (_e509 > 0f));
let _e514 = select(_e510, _e512, (_e512 < _e510));
let _e521 = select(0i, select(select(i32(_e514), i32(-2147483648), (_e514 < -2147483600f)), 2147483647i, (_e514 > 2147483500f)), (_e514 == _e514));
let _e529 = global_1.member.member_6.member_12;
let _e530 = (_e529 & 31u);
let _e533 = (_e464 + 0.5f);
let _e534 = (_e459 - 1f);
let _e536 = select(0f, _e533, (_e533 > 0f));
let _e538 = select(_e534, _e536, (_e536 < _e534));
let _e545 = select(0i, select(select(i32(_e538), i32(-2147483648), (_e538 < -2147483600f)), 2147483647i, (_e538 > 2147483500f)), (_e538 == _e538));
let _e552 = (_e474 + 0.5f);
let _e553 = (_e469 - 1f);
let _e555 = select(0f, _e552, (_e552 > 0f));
let _e557 = select(_e553, _e555, (_e555 < _e553));
let _e564 = select(0i, select(select(i32(_e557), i32(-2147483648), (_e557 < -2147483600f)), 2147483647i, (_e557 > 2147483500f)), (_e557 == _e557));
let _e575 = global_1.member.member_6.member_9.member;
let _e581 = global_1.member.member_6.member_9.member_1;
let _e586 = global_1.member.member_6.member_10;
let _e592 = ((bitcast<i32>(_e586) + ((_e521 - select(0i, 1i, (_e514 < f32(_e521)))) >> bitcast<u32>(_e530))) + (bitcast<i32>(_e575) * (((_e545 - select(0i, 1i, (_e538 < f32(_e545)))) >> bitcast<u32>(_e530)) + (bitcast<i32>(_e581) * ((_e564 - select(0i, 1i, (_e557 < f32(_e564)))) >> bitcast<u32>(_e530))))));
let _e594 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e596 = select(_e594, _e592, (_e592 < _e594));
let _e602 = global_3.member[bitcast<u32>(select(0i, _e596, (_e596 > 0i)))];
let _e608 = global_1.member.member_1;
let _e615 = (((_e608 & 64u) != 0u) || ((((select(_e488, _e485, (_e485 > _e488)) <= _e444) && ((select(_e505, _e502, (_e502 > _e505)) > _e444) || (_e602 != 0u))) && true) && ((_e608 & 32u) != 0u)));
if (select(0u, select(7u, select(3u, 1u, ((((_e257 == 0f) && (_e264 == 0f)) && (_e366 == 0f)) && (_e369 == 0f))), _e615), (_e238 == 0f)) > 1u) {
if _e276 {
break;
}
if _e276 {
break;
}
let _e622 = (_e103.member_2 == 2u);
let _e625 = (((_e103.member_2 == 1u) || _e622) || (_e103.member_2 == 5u));
if _e625 {
let _e627 = select(-1f, _e454, (_e454 > -1f));
let _e629 = select(_e449, _e627, (_e627 < _e449));
let _e636 = select(0i, select(select(i32(_e629), i32(-2147483648), (_e629 < -2147483600f)), 2147483647i, (_e629 > 2147483500f)), (_e629 == _e629));
let _e640 = (_e636 - select(0i, 1i, (_e629 < f32(_e636))));
let _e642 = select(-1f, _e464, (_e464 > -1f));
let _e644 = select(_e459, _e642, (_e642 < _e459));
let _e651 = select(0i, select(select(i32(_e644), i32(-2147483648), (_e644 < -2147483600f)), 2147483647i, (_e644 > 2147483500f)), (_e644 == _e644));
let _e655 = (_e651 - select(0i, 1i, (_e644 < f32(_e651))));
let _e657 = select(-1f, _e474, (_e474 > -1f));
let _e659 = select(_e469, _e657, (_e657 < _e469));
let _e666 = select(0i, select(select(i32(_e659), i32(-2147483648), (_e659 < -2147483600f)), 2147483647i, (_e659 > 2147483500f)), (_e659 == _e659));
let _e670 = (_e666 - select(0i, 1i, (_e659 < f32(_e666))));
let _e674 = global_1.member.member_6.member_7;
let _e678 = global_1.member.member_6.member_8;
let _e686 = (select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < -2147483600f)), 2147483647i, (_e459 > 2147483500f)), (_e459 == _e459)) - 1i);
let _e687 = (_e655 - 1i);
let _e692 = (_e655 + 1i);
let _e695 = (_e655 + 2i);
let _e705 = (select(0i, select(select(i32(_e469), i32(-2147483648), (_e469 < -2147483600f)), 2147483647i, (_e469 > 2147483500f)), (_e469 == _e469)) - 1i);
let _e706 = (_e670 - 1i);
let _e711 = (_e670 + 1i);
let _e714 = (_e670 + 2i);
let _e724 = (select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < -2147483600f)), 2147483647i, (_e449 > 2147483500f)), (_e449 == _e449)) - 1i);
let _e725 = (_e640 - 1i);
let _e730 = (_e640 + 1i);
let _e733 = (_e640 + 2i);
let _e736 = (select(0i, _e687, (_e687 > 0i)) * _e674);
let _e737 = (select(0i, _e655, (_e655 > 0i)) * _e674);
let _e738 = (select(_e686, _e692, (_e692 < _e686)) * _e674);
let _e739 = (select(_e686, _e695, (_e695 < _e686)) * _e674);
let _e740 = (select(0i, _e706, (_e706 > 0i)) * _e678);
let _e741 = (select(0i, _e670, (_e670 > 0i)) * _e678);
let _e742 = (select(_e705, _e711, (_e711 < _e705)) * _e678);
let _e743 = (select(_e705, _e714, (_e714 < _e705)) * _e678);
local_4 = type_28(array<i32, 4>(select(0i, _e725, (_e725 > 0i)), select(0i, _e640, (_e640 > 0i)), select(_e724, _e730, (_e730 < _e724)), select(_e724, _e733, (_e733 < _e724))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_5 = vec3<f32>((_e454 - f32(_e640)), (_e464 - f32(_e655)), (_e474 - f32(_e670)));
let _e754 = (_e741 + _e737);
let _e757 = local_4.member[0u];
let _e758 = (_e754 + _e757);
let _e760 = (bitcast<i32>(_e89) - 1i);
let _e762 = select(_e760, _e758, (_e758 < _e760));
let _e767 = global_2.member[bitcast<u32>(select(0i, _e762, (_e762 > 0i)))];
let _e768 = bitcast<f32>(_e767);
let _e771 = local_4.member[1u];
let _e772 = (_e754 + _e771);
let _e774 = select(_e760, _e772, (_e772 < _e760));
let _e779 = global_2.member[bitcast<u32>(select(0i, _e774, (_e774 > 0i)))];
let _e780 = bitcast<f32>(_e779);
let _e783 = local_4.member[2u];
let _e784 = (_e754 + _e783);
let _e786 = select(_e760, _e784, (_e784 < _e760));
let _e791 = global_2.member[bitcast<u32>(select(0i, _e786, (_e786 > 0i)))];
let _e792 = bitcast<f32>(_e791);
let _e795 = local_4.member[3u];
let _e796 = (_e754 + _e795);
let _e798 = select(_e760, _e796, (_e796 < _e760));
let _e803 = global_2.member[bitcast<u32>(select(0i, _e798, (_e798 > 0i)))];
let _e805 = local_5[0u];
let _e808 = (_e768 + ((_e780 - _e768) * _e805));
let _e809 = local_5[0u];
let _e812 = (_e780 + ((_e792 - _e780) * _e809));
let _e813 = local_5[0u];
let _e816 = (_e792 + ((bitcast<f32>(_e803) - _e792) * _e813));
let _e817 = (_e741 + _e738);
let _e818 = local_4.member[0u];
let _e819 = (_e817 + _e818);
let _e821 = select(_e760, _e819, (_e819 < _e760));
let _e826 = global_2.member[bitcast<u32>(select(0i, _e821, (_e821 > 0i)))];
let _e827 = bitcast<f32>(_e826);
let _e828 = local_4.member[1u];
let _e829 = (_e817 + _e828);
let _e831 = select(_e760, _e829, (_e829 < _e760));
let _e836 = global_2.member[bitcast<u32>(select(0i, _e831, (_e831 > 0i)))];
let _e837 = bitcast<f32>(_e836);
let _e838 = local_4.member[2u];
let _e839 = (_e817 + _e838);
let _e841 = select(_e760, _e839, (_e839 < _e760));
let _e846 = global_2.member[bitcast<u32>(select(0i, _e841, (_e841 > 0i)))];
let _e847 = bitcast<f32>(_e846);
let _e848 = local_4.member[3u];
let _e849 = (_e817 + _e848);
let _e851 = select(_e760, _e849, (_e849 < _e760));
let _e856 = global_2.member[bitcast<u32>(select(0i, _e851, (_e851 > 0i)))];
let _e858 = local_5[0u];
let _e862 = local_5[0u];
let _e865 = (_e837 + ((_e847 - _e837) * _e862));
let _e866 = local_5[0u];
let _e870 = (_e742 + _e737);
let _e871 = local_4.member[0u];
let _e872 = (_e870 + _e871);
let _e874 = select(_e760, _e872, (_e872 < _e760));
let _e879 = global_2.member[bitcast<u32>(select(0i, _e874, (_e874 > 0i)))];
let _e880 = bitcast<f32>(_e879);
let _e881 = local_4.member[1u];
let _e882 = (_e870 + _e881);
let _e884 = select(_e760, _e882, (_e882 < _e760));
let _e889 = global_2.member[bitcast<u32>(select(0i, _e884, (_e884 > 0i)))];
let _e890 = bitcast<f32>(_e889);
let _e891 = local_4.member[2u];
let _e892 = (_e870 + _e891);
let _e894 = select(_e760, _e892, (_e892 < _e760));
let _e899 = global_2.member[bitcast<u32>(select(0i, _e894, (_e894 > 0i)))];
let _e900 = bitcast<f32>(_e899);
let _e901 = local_4.member[3u];
let _e902 = (_e870 + _e901);
let _e904 = select(_e760, _e902, (_e902 < _e760));
let _e909 = global_2.member[bitcast<u32>(select(0i, _e904, (_e904 > 0i)))];
let _e911 = local_5[0u];
let _e914 = (_e880 + ((_e890 - _e880) * _e911));
let _e915 = local_5[0u];
let _e918 = (_e890 + ((_e900 - _e890) * _e915));
let _e919 = local_5[0u];
let _e922 = (_e900 + ((bitcast<f32>(_e909) - _e900) * _e919));
let _e923 = (_e742 + _e738);
let _e924 = local_4.member[0u];
let _e925 = (_e923 + _e924);
let _e927 = select(_e760, _e925, (_e925 < _e760));
let _e932 = global_2.member[bitcast<u32>(select(0i, _e927, (_e927 > 0i)))];
let _e933 = bitcast<f32>(_e932);
let _e934 = local_4.member[1u];
let _e935 = (_e923 + _e934);
let _e937 = select(_e760, _e935, (_e935 < _e760));
let _e942 = global_2.member[bitcast<u32>(select(0i, _e937, (_e937 > 0i)))];
let _e943 = bitcast<f32>(_e942);
let _e944 = local_4.member[2u];
let _e945 = (_e923 + _e944);
let _e947 = select(_e760, _e945, (_e945 < _e760));
let _e952 = global_2.member[bitcast<u32>(select(0i, _e947, (_e947 > 0i)))];
let _e953 = bitcast<f32>(_e952);
let _e954 = local_4.member[3u];
let _e955 = (_e923 + _e954);
let _e957 = select(_e760, _e955, (_e955 < _e760));
let _e962 = global_2.member[bitcast<u32>(select(0i, _e957, (_e957 > 0i)))];
let _e964 = local_5[0u];
let _e968 = local_5[0u];
let _e971 = (_e943 + ((_e953 - _e943) * _e968));
let _e972 = local_5[0u];
let _e976 = (_e741 + _e736);
let _e977 = local_4.member[1u];
let _e978 = (_e976 + _e977);
let _e980 = select(_e760, _e978, (_e978 < _e760));
let _e985 = global_2.member[bitcast<u32>(select(0i, _e980, (_e980 > 0i)))];
let _e986 = bitcast<f32>(_e985);
let _e987 = local_4.member[2u];
let _e988 = (_e976 + _e987);
let _e990 = select(_e760, _e988, (_e988 < _e760));
let _e995 = global_2.member[bitcast<u32>(select(0i, _e990, (_e990 > 0i)))];
let _e997 = local_5[0u];
let _e1000 = (_e986 + ((bitcast<f32>(_e995) - _e986) * _e997));
let _e1001 = (_e741 + _e739);
let _e1002 = local_4.member[1u];
let _e1003 = (_e1001 + _e1002);
let _e1005 = select(_e760, _e1003, (_e1003 < _e760));
let _e1010 = global_2.member[bitcast<u32>(select(0i, _e1005, (_e1005 > 0i)))];
let _e1011 = bitcast<f32>(_e1010);
let _e1012 = local_4.member[2u];
let _e1013 = (_e1001 + _e1012);
let _e1015 = select(_e760, _e1013, (_e1013 < _e760));
let _e1020 = global_2.member[bitcast<u32>(select(0i, _e1015, (_e1015 > 0i)))];
let _e1022 = local_5[0u];
let _e1026 = (_e742 + _e736);
let _e1027 = local_4.member[1u];
let _e1028 = (_e1026 + _e1027);
let _e1030 = select(_e760, _e1028, (_e1028 < _e760));
let _e1035 = global_2.member[bitcast<u32>(select(0i, _e1030, (_e1030 > 0i)))];
let _e1036 = bitcast<f32>(_e1035);
let _e1037 = local_4.member[2u];
let _e1038 = (_e1026 + _e1037);
let _e1040 = select(_e760, _e1038, (_e1038 < _e760));
let _e1045 = global_2.member[bitcast<u32>(select(0i, _e1040, (_e1040 > 0i)))];
let _e1047 = local_5[0u];
let _e1050 = (_e1036 + ((bitcast<f32>(_e1045) - _e1036) * _e1047));
let _e1051 = (_e742 + _e739);
let _e1052 = local_4.member[1u];
let _e1053 = (_e1051 + _e1052);
let _e1055 = select(_e760, _e1053, (_e1053 < _e760));
let _e1060 = global_2.member[bitcast<u32>(select(0i, _e1055, (_e1055 > 0i)))];
let _e1061 = bitcast<f32>(_e1060);
let _e1062 = local_4.member[2u];
let _e1063 = (_e1051 + _e1062);
let _e1065 = select(_e760, _e1063, (_e1063 < _e760));
let _e1070 = global_2.member[bitcast<u32>(select(0i, _e1065, (_e1065 > 0i)))];
let _e1072 = local_5[0u];
let _e1076 = (_e740 + _e737);
let _e1077 = local_4.member[1u];
let _e1078 = (_e1076 + _e1077);
let _e1080 = select(_e760, _e1078, (_e1078 < _e760));
let _e1085 = global_2.member[bitcast<u32>(select(0i, _e1080, (_e1080 > 0i)))];
let _e1086 = bitcast<f32>(_e1085);
let _e1087 = local_4.member[2u];
let _e1088 = (_e1076 + _e1087);
let _e1090 = select(_e760, _e1088, (_e1088 < _e760));
let _e1095 = global_2.member[bitcast<u32>(select(0i, _e1090, (_e1090 > 0i)))];
let _e1097 = local_5[0u];
let _e1100 = (_e1086 + ((bitcast<f32>(_e1095) - _e1086) * _e1097));
let _e1101 = (_e743 + _e737);
let _e1102 = local_4.member[1u];
let _e1103 = (_e1101 + _e1102);
let _e1105 = select(_e760, _e1103, (_e1103 < _e760));
let _e1110 = global_2.member[bitcast<u32>(select(0i, _e1105, (_e1105 > 0i)))];
let _e1111 = bitcast<f32>(_e1110);
let _e1112 = local_4.member[2u];
let _e1113 = (_e1101 + _e1112);
let _e1115 = select(_e760, _e1113, (_e1113 < _e760));
let _e1120 = global_2.member[bitcast<u32>(select(0i, _e1115, (_e1115 > 0i)))];
let _e1122 = local_5[0u];
let _e1125 = (_e1111 + ((bitcast<f32>(_e1120) - _e1111) * _e1122));
let _e1126 = (_e740 + _e738);
let _e1127 = local_4.member[1u];
let _e1128 = (_e1126 + _e1127);
let _e1130 = select(_e760, _e1128, (_e1128 < _e760));
let _e1135 = global_2.member[bitcast<u32>(select(0i, _e1130, (_e1130 > 0i)))];
let _e1136 = bitcast<f32>(_e1135);
let _e1137 = local_4.member[2u];
let _e1138 = (_e1126 + _e1137);
let _e1140 = select(_e760, _e1138, (_e1138 < _e760));
let _e1145 = global_2.member[bitcast<u32>(select(0i, _e1140, (_e1140 > 0i)))];
let _e1147 = local_5[0u];
let _e1151 = (_e743 + _e738);
let _e1152 = local_4.member[1u];
let _e1153 = (_e1151 + _e1152);
let _e1155 = select(_e760, _e1153, (_e1153 < _e760));
let _e1160 = global_2.member[bitcast<u32>(select(0i, _e1155, (_e1155 > 0i)))];
let _e1161 = bitcast<f32>(_e1160);
let _e1162 = local_4.member[2u];
let _e1163 = (_e1151 + _e1162);
let _e1165 = select(_e760, _e1163, (_e1163 < _e760));
let _e1170 = global_2.member[bitcast<u32>(select(0i, _e1165, (_e1165 > 0i)))];
let _e1172 = local_5[0u];
let _e1177 = local_5[1u];
let _e1180 = (_e812 + ((_e865 - _e812) * _e1177));
let _e1181 = local_5[1u];
let _e1184 = (_e918 + ((_e971 - _e918) * _e1181));
let _e1185 = local_5[1u];
let _e1188 = (_e808 + (((_e827 + ((_e837 - _e827) * _e858)) - _e808) * _e1185));
let _e1189 = local_5[1u];
let _e1194 = local_5[2u];
let _e1198 = local_5[1u];
let _e1201 = (_e816 + (((_e847 + ((bitcast<f32>(_e856) - _e847) * _e866)) - _e816) * _e1198));
let _e1202 = local_5[1u];
let _e1206 = local_5[2u];
let _e1210 = local_5[1u];
let _e1213 = (_e1000 + ((_e812 - _e1000) * _e1210));
let _e1214 = local_5[1u];
let _e1218 = local_5[2u];
let _e1222 = local_5[1u];
let _e1225 = (_e865 + (((_e1011 + ((bitcast<f32>(_e1020) - _e1011) * _e1022)) - _e865) * _e1222));
let _e1226 = local_5[1u];
let _e1230 = local_5[2u];
let _e1234 = local_5[1u];
let _e1237 = (_e1100 + (((_e1136 + ((bitcast<f32>(_e1145) - _e1136) * _e1147)) - _e1100) * _e1234));
let _e1238 = local_5[2u];
let _e1242 = local_5[1u];
let _e1246 = local_5[2u];
let _e1250 = local_5[2u];
let _e1257 = global_1.member.member_6.member_5;
let _e1262 = global_1.member.member_6.member_6;
let _e1263 = (((_e1180 + ((_e1184 - _e1180) * _e1250)) * _e1257) + _e1262);
let _e1265 = select(0f, _e1263, (_e1263 > 0f));
let _e1267 = select(1f, _e1265, (_e1265 < 1f));
let _e1269 = (((_e1188 + (((_e914 + (((_e933 + ((_e943 - _e933) * _e964)) - _e914) * _e1189)) - _e1188) * _e1194)) * _e1257) + _e1262);
let _e1271 = select(0f, _e1269, (_e1269 > 0f));
let _e1273 = select(1f, _e1271, (_e1271 < 1f));
let _e1275 = (((_e1201 + (((_e922 + (((_e953 + ((bitcast<f32>(_e962) - _e953) * _e972)) - _e922) * _e1202)) - _e1201) * _e1206)) * _e1257) + _e1262);
let _e1277 = select(0f, _e1275, (_e1275 > 0f));
let _e1279 = select(1f, _e1277, (_e1277 < 1f));
let _e1281 = (((_e1213 + (((_e1050 + ((_e918 - _e1050) * _e1214)) - _e1213) * _e1218)) * _e1257) + _e1262);
let _e1283 = select(0f, _e1281, (_e1281 > 0f));
let _e1285 = select(1f, _e1283, (_e1283 < 1f));
let _e1287 = (((_e1225 + (((_e971 + (((_e1061 + ((bitcast<f32>(_e1070) - _e1061) * _e1072)) - _e971) * _e1226)) - _e1225) * _e1230)) * _e1257) + _e1262);
let _e1289 = select(0f, _e1287, (_e1287 > 0f));
let _e1291 = select(1f, _e1289, (_e1289 < 1f));
let _e1293 = (((_e1237 + ((_e1180 - _e1237) * _e1238)) * _e1257) + _e1262);
let _e1295 = select(0f, _e1293, (_e1293 > 0f));
let _e1297 = select(1f, _e1295, (_e1295 < 1f));
let _e1299 = (((_e1184 + (((_e1125 + (((_e1161 + ((bitcast<f32>(_e1170) - _e1161) * _e1172)) - _e1125) * _e1242)) - _e1184) * _e1246)) * _e1257) + _e1262);
let _e1301 = select(0f, _e1299, (_e1299 > 0f));
let _e1303 = select(1f, _e1301, (_e1301 < 1f));
let _e1304 = (_e1267 * 1024f);
let _e1305 = (1024f - 1f);
let _e1307 = select(0f, _e1304, (_e1304 > 0f));
let _e1309 = select(_e1305, _e1307, (_e1307 < _e1305));
let _e1316 = select(0i, select(select(i32(_e1309), i32(-2147483648), (_e1309 < -2147483600f)), 2147483647i, (_e1309 > 2147483500f)), (_e1309 == _e1309));
let _e1320 = (_e1316 - select(0i, 1i, (_e1309 < f32(_e1316))));
let _e1321 = (262147i + _e1320);
let _e1323 = (bitcast<i32>(_e93) - 1i);
let _e1325 = select(_e1323, _e1321, (_e1321 < _e1323));
let _e1331 = global_4.member[bitcast<u32>(select(0i, _e1325, (_e1325 > 0i)))];
let _e1341 = select(_e1323, 262146i, (262146i < _e1323));
let _e1347 = global_4.member[bitcast<u32>(select(0i, _e1341, (_e1341 > 0i)))];
let _e1348 = bitcast<f32>(_e1347);
let _e1349 = (f32((bitcast<i32>((_e1331 & 4095u)) - 2048i)) * _e1348);
let _e1351 = select(_e1323, 262144i, (262144i < _e1323));
let _e1357 = global_4.member[bitcast<u32>(select(0i, _e1351, (_e1351 > 0i)))];
let _e1358 = bitcast<f32>(_e1357);
let _e1360 = select(_e1323, 262145i, (262145i < _e1323));
let _e1366 = global_4.member[bitcast<u32>(select(0i, _e1360, (_e1360 > 0i)))];
let _e1367 = bitcast<f32>(_e1366);
let _e1373 = ((_e1358 + (f32(bitcast<i32>((_e1331 >> bitcast<u32>(12u)))) * _e1367)) + (_e1349 * (_e1304 - f32(_e1320))));
let _e1374 = (_e1349 * 1024f);
if _e622 {
let _e1381 = ((0.5f * (_e1279 - _e1273)) * _e1374);
let _e1382 = ((0.5f * (_e1291 - _e1285)) * _e1374);
let _e1383 = ((0.5f * (_e1303 - _e1297)) * _e1374);
phi_3695_ = type_29(_e1373, vec3<f32>(_e1381, _e1382, _e1383), vec3<f32>((_e1381 * _e1373), (_e1382 * _e1373), (_e1383 * _e1373)));
} else {
let _e1390 = (_e1273 * 1024f);
let _e1392 = select(0f, _e1390, (_e1390 > 0f));
let _e1394 = select(_e1305, _e1392, (_e1392 < _e1305));
let _e1401 = select(0i, select(select(i32(_e1394), i32(-2147483648), (_e1394 < -2147483600f)), 2147483647i, (_e1394 > 2147483500f)), (_e1394 == _e1394));
let _e1405 = (_e1401 - select(0i, 1i, (_e1394 < f32(_e1401))));
let _e1406 = (262147i + _e1405);
let _e1408 = select(_e1323, _e1406, (_e1406 < _e1323));
let _e1414 = global_4.member[bitcast<u32>(select(0i, _e1408, (_e1408 > 0i)))];
let _e1429 = ((_e1358 + (f32(bitcast<i32>((_e1414 >> bitcast<u32>(12u)))) * _e1367)) + ((f32((bitcast<i32>((_e1414 & 4095u)) - 2048i)) * _e1348) * (_e1390 - f32(_e1405))));
let _e1430 = (_e1279 * 1024f);
let _e1432 = select(0f, _e1430, (_e1430 > 0f));
let _e1434 = select(_e1305, _e1432, (_e1432 < _e1305));
let _e1441 = select(0i, select(select(i32(_e1434), i32(-2147483648), (_e1434 < -2147483600f)), 2147483647i, (_e1434 > 2147483500f)), (_e1434 == _e1434));
let _e1445 = (_e1441 - select(0i, 1i, (_e1434 < f32(_e1441))));
let _e1446 = (262147i + _e1445);
let _e1448 = select(_e1323, _e1446, (_e1446 < _e1323));
let _e1454 = global_4.member[bitcast<u32>(select(0i, _e1448, (_e1448 > 0i)))];
let _e1469 = ((_e1358 + (f32(bitcast<i32>((_e1454 >> bitcast<u32>(12u)))) * _e1367)) + ((f32((bitcast<i32>((_e1454 & 4095u)) - 2048i)) * _e1348) * (_e1430 - f32(_e1445))));
let _e1470 = (_e1285 * 1024f);
let _e1472 = select(0f, _e1470, (_e1470 > 0f));
let _e1474 = select(_e1305, _e1472, (_e1472 < _e1305));
let _e1481 = select(0i, select(select(i32(_e1474), i32(-2147483648), (_e1474 < -2147483600f)), 2147483647i, (_e1474 > 2147483500f)), (_e1474 == _e1474));
let _e1485 = (_e1481 - select(0i, 1i, (_e1474 < f32(_e1481))));
let _e1486 = (262147i + _e1485);
let _e1488 = select(_e1323, _e1486, (_e1486 < _e1323));
let _e1494 = global_4.member[bitcast<u32>(select(0i, _e1488, (_e1488 > 0i)))];
let _e1509 = ((_e1358 + (f32(bitcast<i32>((_e1494 >> bitcast<u32>(12u)))) * _e1367)) + ((f32((bitcast<i32>((_e1494 & 4095u)) - 2048i)) * _e1348) * (_e1470 - f32(_e1485))));
let _e1510 = (_e1291 * 1024f);
let _e1512 = select(0f, _e1510, (_e1510 > 0f));
let _e1514 = select(_e1305, _e1512, (_e1512 < _e1305));
let _e1521 = select(0i, select(select(i32(_e1514), i32(-2147483648), (_e1514 < -2147483600f)), 2147483647i, (_e1514 > 2147483500f)), (_e1514 == _e1514));
let _e1525 = (_e1521 - select(0i, 1i, (_e1514 < f32(_e1521))));
let _e1526 = (262147i + _e1525);
let _e1528 = select(_e1323, _e1526, (_e1526 < _e1323));
let _e1534 = global_4.member[bitcast<u32>(select(0i, _e1528, (_e1528 > 0i)))];
let _e1549 = ((_e1358 + (f32(bitcast<i32>((_e1534 >> bitcast<u32>(12u)))) * _e1367)) + ((f32((bitcast<i32>((_e1534 & 4095u)) - 2048i)) * _e1348) * (_e1510 - f32(_e1525))));
let _e1550 = (_e1297 * 1024f);
let _e1552 = select(0f, _e1550, (_e1550 > 0f));
let _e1554 = select(_e1305, _e1552, (_e1552 < _e1305));
let _e1561 = select(0i, select(select(i32(_e1554), i32(-2147483648), (_e1554 < -2147483600f)), 2147483647i, (_e1554 > 2147483500f)), (_e1554 == _e1554));
let _e1565 = (_e1561 - select(0i, 1i, (_e1554 < f32(_e1561))));
let _e1566 = (262147i + _e1565);
let _e1568 = select(_e1323, _e1566, (_e1566 < _e1323));
let _e1574 = global_4.member[bitcast<u32>(select(0i, _e1568, (_e1568 > 0i)))];
let _e1589 = ((_e1358 + (f32(bitcast<i32>((_e1574 >> bitcast<u32>(12u)))) * _e1367)) + ((f32((bitcast<i32>((_e1574 & 4095u)) - 2048i)) * _e1348) * (_e1550 - f32(_e1565))));
let _e1590 = (_e1303 * 1024f);
let _e1592 = select(0f, _e1590, (_e1590 > 0f));
let _e1594 = select(_e1305, _e1592, (_e1592 < _e1305));
let _e1601 = select(0i, select(select(i32(_e1594), i32(-2147483648), (_e1594 < -2147483600f)), 2147483647i, (_e1594 > 2147483500f)), (_e1594 == _e1594));
let _e1605 = (_e1601 - select(0i, 1i, (_e1594 < f32(_e1601))));
let _e1606 = (262147i + _e1605);
let _e1608 = select(_e1323, _e1606, (_e1606 < _e1323));
let _e1614 = global_4.member[bitcast<u32>(select(0i, _e1608, (_e1608 > 0i)))];
let _e1629 = ((_e1358 + (f32(bitcast<i32>((_e1614 >> bitcast<u32>(12u)))) * _e1367)) + ((f32((bitcast<i32>((_e1614 & 4095u)) - 2048i)) * _e1348) * (_e1590 - f32(_e1605))));
let _e1630 = (_e1469 - _e1429);
let _e1632 = (_e1549 - _e1509);
let _e1634 = (_e1629 - _e1589);
phi_3695_ = type_29(_e1373, vec3<f32>((0.5f * _e1630), (0.5f * _e1632), (0.5f * _e1634)), vec3<f32>((0.25f * (_e1630 * (_e1469 + _e1429))), (0.25f * (_e1632 * (_e1549 + _e1509))), (0.25f * (_e1634 * (_e1629 + _e1589)))));
}
let _e1649 = phi_3695_;
let _e1664 = select(0f, 1f, ((((((_e428 >= -0.5f) && (_e428 <= _e450)) && (_e434 >= -0.5f)) && (_e434 <= _e460)) && (_e440 >= -0.5f)) && (_e440 <= _e470)));
let _e1666 = (0.5f * (_e1279 - _e1273));
let _e1668 = (0.5f * (_e1291 - _e1285));
let _e1670 = (0.5f * (_e1303 - _e1297));
let _e1676 = global_1.member.member_6.member.member.member;
let _e1682 = global_1.member.member_6.member.member.member_1;
let _e1688 = global_1.member.member_6.member.member.member_2;
let _e1694 = global_1.member.member_6.member_1.member.member;
let _e1700 = global_1.member.member_6.member_1.member.member_1;
let _e1706 = global_1.member.member_6.member_1.member.member_2;
let _e1712 = global_1.member.member_6.member_2.member.member;
let _e1718 = global_1.member.member_6.member_2.member.member_1;
let _e1724 = global_1.member.member_6.member_2.member.member_2;
phi_4341_ = type_30(_e1267, vec3<f32>(((((_e1676 * _e1666) + (_e1694 * _e1668)) + (_e1712 * _e1670)) * _e1664), ((((_e1682 * _e1666) + (_e1700 * _e1668)) + (_e1718 * _e1670)) * _e1664), ((((_e1688 * _e1666) + (_e1706 * _e1668)) + (_e1724 * _e1670)) * _e1664)), _e1649.member, vec3<f32>(((((_e1676 * _e1649.member_2.x) + (_e1694 * _e1649.member_2.y)) + (_e1712 * _e1649.member_2.z)) * _e1664), ((((_e1682 * _e1649.member_2.x) + (_e1700 * _e1649.member_2.y)) + (_e1718 * _e1649.member_2.z)) * _e1664), ((((_e1688 * _e1649.member_2.x) + (_e1706 * _e1649.member_2.y)) + (_e1724 * _e1649.member_2.z)) * _e1664)), vec3<f32>(((((_e1676 * _e1649.member_1.x) + (_e1694 * _e1649.member_1.y)) + (_e1712 * _e1649.member_1.z)) * _e1664), ((((_e1682 * _e1649.member_1.x) + (_e1700 * _e1649.member_1.y)) + (_e1718 * _e1649.member_1.z)) * _e1664), ((((_e1688 * _e1649.member_1.x) + (_e1706 * _e1649.member_1.y)) + (_e1724 * _e1649.member_1.z)) * _e1664)));
} else {
let _e1790 = select(-1f, _e454, (_e454 > -1f));
let _e1792 = select(_e449, _e1790, (_e1790 < _e449));
let _e1799 = select(0i, select(select(i32(_e1792), i32(-2147483648), (_e1792 < -2147483600f)), 2147483647i, (_e1792 > 2147483500f)), (_e1792 == _e1792));
let _e1803 = (_e1799 - select(0i, 1i, (_e1792 < f32(_e1799))));
let _e1805 = select(-1f, _e464, (_e464 > -1f));
let _e1807 = select(_e459, _e1805, (_e1805 < _e459));
let _e1814 = select(0i, select(select(i32(_e1807), i32(-2147483648), (_e1807 < -2147483600f)), 2147483647i, (_e1807 > 2147483500f)), (_e1807 == _e1807));
let _e1818 = (_e1814 - select(0i, 1i, (_e1807 < f32(_e1814))));
let _e1820 = select(-1f, _e474, (_e474 > -1f));
let _e1822 = select(_e469, _e1820, (_e1820 < _e469));
let _e1829 = select(0i, select(select(i32(_e1822), i32(-2147483648), (_e1822 < -2147483600f)), 2147483647i, (_e1822 > 2147483500f)), (_e1822 == _e1822));
let _e1833 = (_e1829 - select(0i, 1i, (_e1822 < f32(_e1829))));
let _e1837 = global_1.member.member_6.member_7;
let _e1841 = global_1.member.member_6.member_8;
let _e1849 = (select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < -2147483600f)), 2147483647i, (_e459 > 2147483500f)), (_e459 == _e459)) - 1i);
let _e1852 = (_e1818 + 1i);
let _e1862 = (select(0i, select(select(i32(_e469), i32(-2147483648), (_e469 < -2147483600f)), 2147483647i, (_e469 > 2147483500f)), (_e469 == _e469)) - 1i);
let _e1865 = (_e1833 + 1i);
let _e1875 = (select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < -2147483600f)), 2147483647i, (_e449 > 2147483500f)), (_e449 == _e449)) - 1i);
let _e1876 = (_e1803 - 1i);
let _e1881 = (_e1803 + 1i);
let _e1884 = (_e1803 + 2i);
let _e1887 = (select(0i, _e1818, (_e1818 > 0i)) * _e1837);
let _e1888 = (select(_e1849, _e1852, (_e1852 < _e1849)) * _e1837);
let _e1889 = (select(0i, _e1833, (_e1833 > 0i)) * _e1841);
let _e1890 = (select(_e1862, _e1865, (_e1865 < _e1862)) * _e1841);
local_2 = type_28(array<i32, 4>(select(0i, _e1876, (_e1876 > 0i)), select(0i, _e1803, (_e1803 > 0i)), select(_e1875, _e1881, (_e1881 < _e1875)), select(_e1875, _e1884, (_e1884 < _e1875))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_3 = vec3<f32>((_e454 - f32(_e1803)), (_e464 - f32(_e1818)), (_e474 - f32(_e1833)));
let _e1901 = (_e1889 + _e1887);
let _e1904 = local_2.member[1u];
let _e1905 = (_e1901 + _e1904);
let _e1907 = (bitcast<i32>(_e89) - 1i);
let _e1909 = select(_e1907, _e1905, (_e1905 < _e1907));
let _e1914 = global_2.member[bitcast<u32>(select(0i, _e1909, (_e1909 > 0i)))];
let _e1915 = bitcast<f32>(_e1914);
let _e1918 = local_2.member[2u];
let _e1919 = (_e1901 + _e1918);
let _e1921 = select(_e1907, _e1919, (_e1919 < _e1907));
let _e1926 = global_2.member[bitcast<u32>(select(0i, _e1921, (_e1921 > 0i)))];
let _e1928 = local_3[0u];
let _e1931 = (_e1915 + ((bitcast<f32>(_e1926) - _e1915) * _e1928));
let _e1932 = (_e1889 + _e1888);
let _e1933 = local_2.member[1u];
let _e1934 = (_e1932 + _e1933);
let _e1936 = select(_e1907, _e1934, (_e1934 < _e1907));
let _e1941 = global_2.member[bitcast<u32>(select(0i, _e1936, (_e1936 > 0i)))];
let _e1942 = bitcast<f32>(_e1941);
let _e1943 = local_2.member[2u];
let _e1944 = (_e1932 + _e1943);
let _e1946 = select(_e1907, _e1944, (_e1944 < _e1907));
let _e1951 = global_2.member[bitcast<u32>(select(0i, _e1946, (_e1946 > 0i)))];
let _e1953 = local_3[0u];
let _e1958 = local_3[1u];
let _e1961 = (_e1931 + (((_e1942 + ((bitcast<f32>(_e1951) - _e1942) * _e1953)) - _e1931) * _e1958));
let _e1962 = (_e1890 + _e1887);
let _e1963 = local_2.member[1u];
let _e1964 = (_e1962 + _e1963);
let _e1966 = select(_e1907, _e1964, (_e1964 < _e1907));
let _e1971 = global_2.member[bitcast<u32>(select(0i, _e1966, (_e1966 > 0i)))];
let _e1972 = bitcast<f32>(_e1971);
let _e1973 = local_2.member[2u];
let _e1974 = (_e1962 + _e1973);
let _e1976 = select(_e1907, _e1974, (_e1974 < _e1907));
let _e1981 = global_2.member[bitcast<u32>(select(0i, _e1976, (_e1976 > 0i)))];
let _e1983 = local_3[0u];
let _e1986 = (_e1972 + ((bitcast<f32>(_e1981) - _e1972) * _e1983));
let _e1987 = (_e1890 + _e1888);
let _e1988 = local_2.member[1u];
let _e1989 = (_e1987 + _e1988);
let _e1991 = select(_e1907, _e1989, (_e1989 < _e1907));
let _e1996 = global_2.member[bitcast<u32>(select(0i, _e1991, (_e1991 > 0i)))];
let _e1997 = bitcast<f32>(_e1996);
let _e1998 = local_2.member[2u];
let _e1999 = (_e1987 + _e1998);
let _e2001 = select(_e1907, _e1999, (_e1999 < _e1907));
let _e2006 = global_2.member[bitcast<u32>(select(0i, _e2001, (_e2001 > 0i)))];
let _e2008 = local_3[0u];
let _e2012 = local_3[1u];
let _e2017 = local_3[2u];
let _e2024 = global_1.member.member_6.member_5;
let _e2029 = global_1.member.member_6.member_6;
let _e2030 = (((_e1961 + (((_e1986 + (((_e1997 + ((bitcast<f32>(_e2006) - _e1997) * _e2008)) - _e1986) * _e2012)) - _e1961) * _e2017)) * _e2024) + _e2029);
let _e2032 = select(0f, _e2030, (_e2030 > 0f));
phi_4341_ = type_30(select(1f, _e2032, (_e2032 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2037 = phi_4341_;
let _e2039 = select(-0.5f, _e392, (_e392 > -0.5f));
let _e2041 = select(_e450, _e2039, (_e2039 < _e450));
let _e2043 = select(-0.5f, _e407, (_e407 > -0.5f));
let _e2045 = select(_e460, _e2043, (_e2043 < _e460));
let _e2047 = select(-0.5f, _e422, (_e422 > -0.5f));
let _e2049 = select(_e470, _e2047, (_e2047 < _e470));
let _e2051 = select(-1f, _e2041, (_e2041 > -1f));
let _e2053 = select(_e449, _e2051, (_e2051 < _e449));
let _e2060 = select(0i, select(select(i32(_e2053), i32(-2147483648), (_e2053 < -2147483600f)), 2147483647i, (_e2053 > 2147483500f)), (_e2053 == _e2053));
let _e2064 = (_e2060 - select(0i, 1i, (_e2053 < f32(_e2060))));
let _e2066 = select(-1f, _e2045, (_e2045 > -1f));
let _e2068 = select(_e459, _e2066, (_e2066 < _e459));
let _e2075 = select(0i, select(select(i32(_e2068), i32(-2147483648), (_e2068 < -2147483600f)), 2147483647i, (_e2068 > 2147483500f)), (_e2068 == _e2068));
let _e2079 = (_e2075 - select(0i, 1i, (_e2068 < f32(_e2075))));
let _e2081 = select(-1f, _e2049, (_e2049 > -1f));
let _e2083 = select(_e469, _e2081, (_e2081 < _e469));
let _e2090 = select(0i, select(select(i32(_e2083), i32(-2147483648), (_e2083 < -2147483600f)), 2147483647i, (_e2083 > 2147483500f)), (_e2083 == _e2083));
let _e2094 = (_e2090 - select(0i, 1i, (_e2083 < f32(_e2090))));
let _e2098 = global_1.member.member_6.member_7;
let _e2102 = global_1.member.member_6.member_8;
let _e2110 = (select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < -2147483600f)), 2147483647i, (_e459 > 2147483500f)), (_e459 == _e459)) - 1i);
let _e2113 = (_e2079 + 1i);
let _e2123 = (select(0i, select(select(i32(_e469), i32(-2147483648), (_e469 < -2147483600f)), 2147483647i, (_e469 > 2147483500f)), (_e469 == _e469)) - 1i);
let _e2126 = (_e2094 + 1i);
let _e2136 = (select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < -2147483600f)), 2147483647i, (_e449 > 2147483500f)), (_e449 == _e449)) - 1i);
let _e2137 = (_e2064 - 1i);
let _e2142 = (_e2064 + 1i);
let _e2145 = (_e2064 + 2i);
let _e2148 = (select(0i, _e2079, (_e2079 > 0i)) * _e2098);
let _e2149 = (select(_e2110, _e2113, (_e2113 < _e2110)) * _e2098);
let _e2150 = (select(0i, _e2094, (_e2094 > 0i)) * _e2102);
let _e2151 = (select(_e2123, _e2126, (_e2126 < _e2123)) * _e2102);
local = type_28(array<i32, 4>(select(0i, _e2137, (_e2137 > 0i)), select(0i, _e2064, (_e2064 > 0i)), select(_e2136, _e2142, (_e2142 < _e2136)), select(_e2136, _e2145, (_e2145 < _e2136))), array<u32, 6>(0u, 0u, 0u, 0u, 0u, 0u));
local_1 = vec3<f32>((_e2041 - f32(_e2064)), (_e2045 - f32(_e2079)), (_e2049 - f32(_e2094)));
let _e2162 = (_e2150 + _e2148);
let _e2165 = local.member[1u];
let _e2166 = (_e2162 + _e2165);
let _e2168 = (bitcast<i32>(_e89) - 1i);
let _e2170 = select(_e2168, _e2166, (_e2166 < _e2168));
let _e2175 = global_2.member[bitcast<u32>(select(0i, _e2170, (_e2170 > 0i)))];
let _e2176 = bitcast<f32>(_e2175);
let _e2179 = local.member[2u];
let _e2180 = (_e2162 + _e2179);
let _e2182 = select(_e2168, _e2180, (_e2180 < _e2168));
let _e2187 = global_2.member[bitcast<u32>(select(0i, _e2182, (_e2182 > 0i)))];
let _e2189 = local_1[0u];
let _e2192 = (_e2176 + ((bitcast<f32>(_e2187) - _e2176) * _e2189));
let _e2193 = (_e2150 + _e2149);
let _e2194 = local.member[1u];
let _e2195 = (_e2193 + _e2194);
let _e2197 = select(_e2168, _e2195, (_e2195 < _e2168));
let _e2202 = global_2.member[bitcast<u32>(select(0i, _e2197, (_e2197 > 0i)))];
let _e2203 = bitcast<f32>(_e2202);
let _e2204 = local.member[2u];
let _e2205 = (_e2193 + _e2204);
let _e2207 = select(_e2168, _e2205, (_e2205 < _e2168));
let _e2212 = global_2.member[bitcast<u32>(select(0i, _e2207, (_e2207 > 0i)))];
let _e2214 = local_1[0u];
let _e2219 = local_1[1u];
let _e2222 = (_e2192 + (((_e2203 + ((bitcast<f32>(_e2212) - _e2203) * _e2214)) - _e2192) * _e2219));
let _e2223 = (_e2151 + _e2148);
let _e2224 = local.member[1u];
let _e2225 = (_e2223 + _e2224);
let _e2227 = select(_e2168, _e2225, (_e2225 < _e2168));
let _e2232 = global_2.member[bitcast<u32>(select(0i, _e2227, (_e2227 > 0i)))];
let _e2233 = bitcast<f32>(_e2232);
let _e2234 = local.member[2u];
let _e2235 = (_e2223 + _e2234);
let _e2237 = select(_e2168, _e2235, (_e2235 < _e2168));
let _e2242 = global_2.member[bitcast<u32>(select(0i, _e2237, (_e2237 > 0i)))];
let _e2244 = local_1[0u];
let _e2247 = (_e2233 + ((bitcast<f32>(_e2242) - _e2233) * _e2244));
let _e2248 = (_e2151 + _e2149);
let _e2249 = local.member[1u];
let _e2250 = (_e2248 + _e2249);
let _e2252 = select(_e2168, _e2250, (_e2250 < _e2168));
let _e2257 = global_2.member[bitcast<u32>(select(0i, _e2252, (_e2252 > 0i)))];
let _e2258 = bitcast<f32>(_e2257);
let _e2259 = local.member[2u];
let _e2260 = (_e2248 + _e2259);
let _e2262 = select(_e2168, _e2260, (_e2260 < _e2168));
let _e2267 = global_2.member[bitcast<u32>(select(0i, _e2262, (_e2262 > 0i)))];
let _e2269 = local_1[0u];
let _e2273 = local_1[1u];
let _e2278 = local_1[2u];
let _e2285 = global_1.member.member_6.member_5;
let _e2290 = global_1.member.member_6.member_6;
let _e2291 = (((_e2222 + (((_e2247 + (((_e2258 + ((bitcast<f32>(_e2267) - _e2258) * _e2269)) - _e2247) * _e2273)) - _e2222) * _e2278)) * _e2285) + _e2290);
let _e2293 = select(0f, _e2291, (_e2291 > 0f));
if ((_e608 & 16u) == 0u) {
phi_5210_ = type_5(1f, 1f, 1f);
} else {
let _e2301 = global_1.member.member_14.member;
let _e2312 = ((((_e2301.member.member * _e303) + (_e2301.member.member_1 * _e312)) + (_e2301.member.member_2 * _e285)) + _e2301.member_1);
let _e2318 = ((((_e2301.member.member * _e324) + (_e2301.member.member_1 * _e329)) + (_e2301.member.member_2 * _e318)) + _e2301.member_1);
let _e2320 = select(_e2318, _e2312, (_e2312 < _e2318));
let _e2322 = select(_e2318, _e2312, (_e2312 > _e2318));
let _e2324 = (_e2322 - _e2320);
let _e2327 = (-(_e2320) / select(1e-30f, _e2324, (_e2324 > 1e-30f)));
let _e2329 = select(0f, _e2327, (_e2327 > 0f));
let _e2335 = select(select(select(1f, _e2329, (_e2329 < 1f)), 1f, (_e2322 <= 0f)), 0f, (_e2320 > 0f));
let _e2340 = global_1.member.member_14.member_1;
let _e2341 = (_e2340 != 0u);
let _e2351 = global_1.member.member_15.member;
let _e2362 = ((((_e2351.member.member * _e303) + (_e2351.member.member_1 * _e312)) + (_e2351.member.member_2 * _e285)) + _e2351.member_1);
let _e2368 = ((((_e2351.member.member * _e324) + (_e2351.member.member_1 * _e329)) + (_e2351.member.member_2 * _e318)) + _e2351.member_1);
let _e2370 = select(_e2368, _e2362, (_e2362 < _e2368));
let _e2372 = select(_e2368, _e2362, (_e2362 > _e2368));
let _e2374 = (_e2372 - _e2370);
let _e2377 = (-(_e2370) / select(1e-30f, _e2374, (_e2374 > 1e-30f)));
let _e2379 = select(0f, _e2377, (_e2377 > 0f));
let _e2385 = select(select(select(1f, _e2379, (_e2379 < 1f)), 1f, (_e2372 <= 0f)), 0f, (_e2370 > 0f));
let _e2390 = global_1.member.member_15.member_1;
let _e2391 = (_e2390 != 0u);
let _e2401 = global_1.member.member_16.member;
let _e2412 = ((((_e2401.member.member * _e303) + (_e2401.member.member_1 * _e312)) + (_e2401.member.member_2 * _e285)) + _e2401.member_1);
let _e2418 = ((((_e2401.member.member * _e324) + (_e2401.member.member_1 * _e329)) + (_e2401.member.member_2 * _e318)) + _e2401.member_1);
let _e2420 = select(_e2418, _e2412, (_e2412 < _e2418));
let _e2422 = select(_e2418, _e2412, (_e2412 > _e2418));
let _e2424 = (_e2422 - _e2420);
let _e2427 = (-(_e2420) / select(1e-30f, _e2424, (_e2424 > 1e-30f)));
let _e2429 = select(0f, _e2427, (_e2427 > 0f));
let _e2435 = select(select(select(1f, _e2429, (_e2429 < 1f)), 1f, (_e2422 <= 0f)), 0f, (_e2420 > 0f));
let _e2440 = global_1.member.member_16.member_1;
let _e2441 = (_e2440 != 0u);
let _e2451 = global_1.member.member_17.member;
let _e2462 = ((((_e2451.member.member * _e303) + (_e2451.member.member_1 * _e312)) + (_e2451.member.member_2 * _e285)) + _e2451.member_1);
let _e2468 = ((((_e2451.member.member * _e324) + (_e2451.member.member_1 * _e329)) + (_e2451.member.member_2 * _e318)) + _e2451.member_1);
let _e2470 = select(_e2468, _e2462, (_e2462 < _e2468));
let _e2472 = select(_e2468, _e2462, (_e2462 > _e2468));
let _e2474 = (_e2472 - _e2470);
let _e2477 = (-(_e2470) / select(1e-30f, _e2474, (_e2474 > 1e-30f)));
let _e2479 = select(0f, _e2477, (_e2477 > 0f));
let _e2485 = select(select(select(1f, _e2479, (_e2479 < 1f)), 1f, (_e2472 <= 0f)), 0f, (_e2470 > 0f));
let _e2490 = global_1.member.member_17.member_1;
let _e2491 = (_e2490 != 0u);
phi_5210_ = type_5(((((1f * _e2335) * _e2385) * _e2435) * _e2485), ((((1f * select(1f, _e2335, _e2341)) * select(1f, _e2385, _e2391)) * select(1f, _e2435, _e2441)) * select(1f, _e2485, _e2491)), ((((1f * select(1f, 0f, (_e2341 && (_e2318 > 0f)))) * select(1f, 0f, (_e2391 && (_e2368 > 0f)))) * select(1f, 0f, (_e2441 && (_e2418 > 0f)))) * select(1f, 0f, (_e2491 && (_e2468 > 0f)))));
}
let _e2500 = phi_5210_;
let _e2501 = (_e324 - _e303);
let _e2502 = (_e329 - _e312);
let _e2503 = (_e318 - _e285);
let _e2508 = (((_e2501 * _e2501) + (_e2502 * _e2502)) + (_e2503 * _e2503));
let _e2512 = (_e480 < 1e-12f);
let _e2514 = (1f / select(_e475, 1f, _e2512));
let _e2516 = ((-0.5f - _e392) * _e2514);
let _e2518 = ((_e450 - _e392) * _e2514);
let _e2524 = select(_e2518, _e2516, (_e2516 < _e2518));
let _e2526 = select(0f, _e2524, (_e2524 > 0f));
let _e2529 = select(select(1f, _e2526, (_e2526 < 1f)), select(2f, 0f, ((_e392 >= -0.5f) && (_e392 <= _e450))), _e2512);
let _e2531 = select(_e2518, _e2516, (_e2516 > _e2518));
let _e2533 = select(0f, _e2531, (_e2531 > 0f));
let _e2536 = select(select(1f, _e2533, (_e2533 < 1f)), 1f, _e2512);
let _e2537 = (_e483 < 1e-12f);
let _e2539 = (1f / select(_e476, 1f, _e2537));
let _e2541 = ((-0.5f - _e407) * _e2539);
let _e2543 = ((_e460 - _e407) * _e2539);
let _e2549 = select(_e2543, _e2541, (_e2541 < _e2543));
let _e2551 = select(0f, _e2549, (_e2549 > 0f));
let _e2554 = select(select(1f, _e2551, (_e2551 < 1f)), select(2f, 0f, ((_e407 >= -0.5f) && (_e407 <= _e460))), _e2537);
let _e2556 = select(_e2543, _e2541, (_e2541 > _e2543));
let _e2558 = select(0f, _e2556, (_e2556 > 0f));
let _e2561 = select(select(1f, _e2558, (_e2558 < 1f)), 1f, _e2537);
let _e2562 = (_e488 < 1e-12f);
let _e2564 = (1f / select(_e477, 1f, _e2562));
let _e2566 = ((-0.5f - _e422) * _e2564);
let _e2568 = ((_e470 - _e422) * _e2564);
let _e2574 = select(_e2568, _e2566, (_e2566 < _e2568));
let _e2576 = select(0f, _e2574, (_e2574 > 0f));
let _e2579 = select(select(1f, _e2576, (_e2576 < 1f)), select(2f, 0f, ((_e422 >= -0.5f) && (_e422 <= _e470))), _e2562);
let _e2581 = select(_e2568, _e2566, (_e2566 > _e2568));
let _e2583 = select(0f, _e2581, (_e2581 > 0f));
let _e2586 = select(select(1f, _e2583, (_e2583 < 1f)), 1f, _e2562);
let _e2588 = select(_e2561, _e2536, (_e2536 < _e2561));
let _e2592 = select(_e2554, _e2529, (_e2529 > _e2554));
let _e2595 = (select(_e2586, _e2588, (_e2588 < _e2586)) - select(_e2579, _e2592, (_e2592 > _e2579)));
let _e2602 = global_1.member.member_5.member_3;
let _e2603 = ((sqrt(select(0f, _e2508, (_e2508 > 0f))) * select(0f, _e2595, (_e2595 > 0f))) * _e2602);
let _e2605 = (select(1f, _e2293, (_e2293 < 1f)) * 255f);
let _e2606 = (_e2037.member * 255f);
let _e2607 = (255f - 1f);
let _e2609 = select(0f, _e2605, (_e2605 > 0f));
let _e2611 = select(_e2607, _e2609, (_e2609 < _e2607));
let _e2618 = select(0i, select(select(i32(_e2611), i32(-2147483648), (_e2611 < -2147483600f)), 2147483647i, (_e2611 > 2147483500f)), (_e2611 == _e2611));
let _e2622 = (_e2618 - select(0i, 1i, (_e2611 < f32(_e2618))));
let _e2624 = select(0f, _e2606, (_e2606 > 0f));
let _e2626 = select(_e2607, _e2624, (_e2624 < _e2607));
let _e2633 = select(0i, select(select(i32(_e2626), i32(-2147483648), (_e2626 < -2147483600f)), 2147483647i, (_e2626 > 2147483500f)), (_e2626 == _e2626));
let _e2637 = (_e2633 - select(0i, 1i, (_e2626 < f32(_e2633))));
let _e2640 = (((_e2622 * 256i) + _e2637) * 4i);
let _e2642 = (_e2605 - f32(_e2622));
let _e2644 = (_e2606 - f32(_e2637));
let _e2646 = (bitcast<i32>(_e93) - 1i);
let _e2648 = select(_e2646, _e2640, (_e2640 < _e2646));
let _e2654 = global_4.member[bitcast<u32>(select(0i, _e2648, (_e2648 > 0i)))];
let _e2655 = (_e2640 + 4i);
let _e2657 = select(_e2646, _e2655, (_e2655 < _e2646));
let _e2663 = global_4.member[bitcast<u32>(select(0i, _e2657, (_e2657 > 0i)))];
let _e2664 = (_e2640 + 1024i);
let _e2666 = select(_e2646, _e2664, (_e2664 < _e2646));
let _e2672 = global_4.member[bitcast<u32>(select(0i, _e2666, (_e2666 > 0i)))];
let _e2673 = (_e2640 + 1028i);
let _e2675 = select(_e2646, _e2673, (_e2673 < _e2646));
let _e2681 = global_4.member[bitcast<u32>(select(0i, _e2675, (_e2675 > 0i)))];
let _e2686 = (bitcast<f32>(((_e2654 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2694 = (_e2686 + (((bitcast<f32>(((_e2663 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2686) * _e2644));
let _e2699 = (bitcast<f32>(((_e2672 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2723 = (bitcast<f32>((((_e2654 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2731 = (_e2723 + (((bitcast<f32>((((_e2663 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2723) * _e2644));
let _e2736 = (bitcast<f32>((((_e2672 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2748 = (_e2640 + 1i);
let _e2750 = select(_e2646, _e2748, (_e2748 < _e2646));
let _e2756 = global_4.member[bitcast<u32>(select(0i, _e2750, (_e2750 > 0i)))];
let _e2757 = (_e2640 + 5i);
let _e2759 = select(_e2646, _e2757, (_e2757 < _e2646));
let _e2765 = global_4.member[bitcast<u32>(select(0i, _e2759, (_e2759 > 0i)))];
let _e2766 = (_e2640 + 1025i);
let _e2768 = select(_e2646, _e2766, (_e2766 < _e2646));
let _e2774 = global_4.member[bitcast<u32>(select(0i, _e2768, (_e2768 > 0i)))];
let _e2775 = (_e2640 + 1029i);
let _e2777 = select(_e2646, _e2775, (_e2775 < _e2646));
let _e2783 = global_4.member[bitcast<u32>(select(0i, _e2777, (_e2777 > 0i)))];
let _e2788 = (bitcast<f32>(((_e2756 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2796 = (_e2788 + (((bitcast<f32>(((_e2765 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2788) * _e2644));
let _e2801 = (bitcast<f32>(((_e2774 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2825 = (bitcast<f32>((((_e2756 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2833 = (_e2825 + (((bitcast<f32>((((_e2765 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2825) * _e2644));
let _e2838 = (bitcast<f32>((((_e2774 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e2853 = (_e2603 * _e2500.member_1);
let _e2855 = -(((_e2731 + (((_e2736 + (((bitcast<f32>((((_e2681 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2736) * _e2644)) - _e2731) * _e2642)) * _e2853));
let _e2857 = select(-87f, _e2855, (_e2855 > -87f));
let _e2859 = select(88f, _e2857, (_e2857 < 88f));
let _e2861 = ((_e2859 * 1.442695f) + 0.5f);
let _e2863 = select(-127f, _e2861, (_e2861 > -127f));
let _e2865 = select(128f, _e2863, (_e2863 < 128f));
let _e2872 = select(0i, select(select(i32(_e2865), i32(-2147483648), (_e2865 < -2147483600f)), 2147483647i, (_e2865 > 2147483500f)), (_e2865 == _e2865));
let _e2876 = (_e2872 - select(0i, 1i, (_e2865 < f32(_e2872))));
let _e2877 = f32(_e2876);
let _e2881 = ((_e2859 - (_e2877 * 0.6933594f)) - (_e2877 * -2.1219444e-4f));
let _e2903 = -(((_e2796 + (((_e2801 + (((bitcast<f32>(((_e2783 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2801) * _e2644)) - _e2796) * _e2642)) * _e2853));
let _e2905 = select(-87f, _e2903, (_e2903 > -87f));
let _e2907 = select(88f, _e2905, (_e2905 < 88f));
let _e2909 = ((_e2907 * 1.442695f) + 0.5f);
let _e2911 = select(-127f, _e2909, (_e2909 > -127f));
let _e2913 = select(128f, _e2911, (_e2911 < 128f));
let _e2920 = select(0i, select(select(i32(_e2913), i32(-2147483648), (_e2913 < -2147483600f)), 2147483647i, (_e2913 > 2147483500f)), (_e2913 == _e2913));
let _e2924 = (_e2920 - select(0i, 1i, (_e2913 < f32(_e2920))));
let _e2925 = f32(_e2924);
let _e2929 = ((_e2907 - (_e2925 * 0.6933594f)) - (_e2925 * -2.1219444e-4f));
let _e2951 = -(((_e2833 + (((_e2838 + (((bitcast<f32>((((_e2783 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2838) * _e2644)) - _e2833) * _e2642)) * _e2853));
let _e2953 = select(-87f, _e2951, (_e2951 > -87f));
let _e2955 = select(88f, _e2953, (_e2953 < 88f));
let _e2957 = ((_e2955 * 1.442695f) + 0.5f);
let _e2959 = select(-127f, _e2957, (_e2957 > -127f));
let _e2961 = select(128f, _e2959, (_e2959 < 128f));
let _e2968 = select(0i, select(select(i32(_e2961), i32(-2147483648), (_e2961 < -2147483600f)), 2147483647i, (_e2961 > 2147483500f)), (_e2961 == _e2961));
let _e2972 = (_e2968 - select(0i, 1i, (_e2961 < f32(_e2968))));
let _e2973 = f32(_e2972);
let _e2977 = ((_e2955 - (_e2973 * 0.6933594f)) - (_e2973 * -2.1219444e-4f));
let _e2999 = -(((_e2694 + (((_e2699 + (((bitcast<f32>(((_e2681 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e2699) * _e2644)) - _e2694) * _e2642)) * (_e2603 * _e2500.member)));
let _e3001 = select(-87f, _e2999, (_e2999 > -87f));
let _e3003 = select(88f, _e3001, (_e3001 < 88f));
let _e3005 = ((_e3003 * 1.442695f) + 0.5f);
let _e3007 = select(-127f, _e3005, (_e3005 > -127f));
let _e3009 = select(128f, _e3007, (_e3007 < 128f));
let _e3016 = select(0i, select(select(i32(_e3009), i32(-2147483648), (_e3009 < -2147483600f)), 2147483647i, (_e3009 > 2147483500f)), (_e3009 == _e3009));
let _e3020 = (_e3016 - select(0i, 1i, (_e3009 < f32(_e3016))));
let _e3021 = f32(_e3020);
let _e3025 = ((_e3003 - (_e3021 * 0.6933594f)) - (_e3021 * -2.1219444e-4f));
let _e3045 = ((1f + (_e3025 * (1f + (_e3025 * (0.5f + (_e3025 * (0.16666667f + (_e3025 * (0.041666668f + (_e3025 * (0.008333334f + (_e3025 * (0.001388889f + (_e3025 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3020 + 127i)) << bitcast<u32>(23i))));
if _e625 {
let _e3060 = global_1.member.member_5.member_4;
let _e3063 = (_e2037.member_3.x * _e2500.member_2);
let _e3065 = (_e2037.member_3.y * _e2500.member_2);
let _e3067 = (_e2037.member_3.z * _e2500.member_2);
let _e3068 = (0.5f * (_e242 / _e194));
let _e3072 = (_e172 + (_e3063 * _e3068));
let _e3073 = (_e183 + (_e3065 * _e3068));
let _e3074 = (_e194 + (_e3067 * _e3068));
let _e3076 = (2f * _e242);
let _e3078 = ((_e3074 * _e3074) + (_e3076 * _e3067));
let _e3082 = (_e3074 + sqrt(select(0f, _e3078, (_e3078 > 0f))));
let _e3086 = (0.5f * (_e3076 / select(1e-6f, _e3082, (_e3082 > 1e-6f))));
let _e3090 = (_e3072 + (_e3063 * _e3086));
let _e3091 = (_e3073 + (_e3065 * _e3086));
let _e3092 = (_e3074 + (_e3067 * _e3086));
let _e3096 = (_e3060 * _e3060);
let _e3098 = (_e3092 * _e3092);
let _e3106 = (((_e3074 <= 0f) || (_e3078 <= 0f)) || ((_e3092 <= 0f) || (_e3098 <= (_e3096 * (((_e3090 * _e3090) + (_e3091 * _e3091)) + _e3098)))));
let _e3120 = (_e172 + ((_e2037.member_4.x * _e2500.member_2) * _e242));
let _e3121 = (_e183 + ((_e2037.member_4.y * _e2500.member_2) * _e242));
let _e3122 = (_e194 + ((_e2037.member_4.z * _e2500.member_2) * _e242));
let _e3124 = (_e3122 * _e3122);
let _e3133 = ((_e608 & 1u) != 0u);
phi_6234_ = select(select(select(_e3092, _e3074, _e3106), _e3122, _e3133), _e194, _e615);
phi_6235_ = select(select(select(_e3091, _e3073, _e3106), _e3121, _e3133), _e183, _e615);
phi_6236_ = select(select(select(_e3090, _e3072, _e3106), _e3120, _e3133), _e172, _e615);
phi_6237_ = (select(_e3106, ((_e3122 <= 0f) || (_e3124 <= (_e3096 * (((_e3120 * _e3120) + (_e3121 * _e3121)) + _e3124)))), _e3133) && !(_e615));
} else {
phi_6234_ = _e194;
phi_6235_ = _e183;
phi_6236_ = _e172;
phi_6237_ = false;
}
let _e3144 = phi_6234_;
let _e3146 = phi_6235_;
let _e3148 = phi_6236_;
let _e3150 = phi_6237_;
global_6.member[_e118] = (_e129 + _e257);
global_6.member[_e130] = (_e139 + _e264);
global_6.member[_e141] = (_e150 + _e366);
global_6.member[_e152] = (_e161 + _e369);
global_6.member[_e163] = _e3148;
global_6.member[_e174] = _e3146;
global_6.member[_e185] = _e3144;
global_6.member[_e196] = select((_e205 * (((1f + (_e2881 * (1f + (_e2881 * (0.5f + (_e2881 * (0.16666667f + (_e2881 * (0.041666668f + (_e2881 * (0.008333334f + (_e2881 * (0.001388889f + (_e2881 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2876 + 127i)) << bitcast<u32>(23i)))) * _e3045)), _e205, _e615);
global_6.member[_e207] = select((_e216 * (((1f + (_e2929 * (1f + (_e2929 * (0.5f + (_e2929 * (0.16666667f + (_e2929 * (0.041666668f + (_e2929 * (0.008333334f + (_e2929 * (0.001388889f + (_e2929 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2924 + 127i)) << bitcast<u32>(23i)))) * _e3045)), _e216, _e615);
global_6.member[_e218] = select((_e227 * (((1f + (_e2977 * (1f + (_e2977 * (0.5f + (_e2977 * (0.16666667f + (_e2977 * (0.041666668f + (_e2977 * (0.008333334f + (_e2977 * (0.001388889f + (_e2977 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2972 + 127i)) << bitcast<u32>(23i)))) * _e3045)), _e227, _e615);
global_6.member[_e229] = select(_e238, 1f, _e3150);
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
