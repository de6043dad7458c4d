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
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_13 {
member: array<f32>,
}
struct type_16 {
member: u32,
member_1: u32,
}
struct type_17 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
member_12: u32,
member_13: u32,
}
struct type_19 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_20 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_21 {
member: type_2,
member_1: type_16,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_17,
member_12: type_18,
member_13: type_19,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_20,
}
struct type_22 {
member: type_21,
}
struct type_23 {
member: i32,
member_1: i32,
}
struct type_26 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(5)
var<storage> global_2: type_13;
@group(0) @binding(1)
var<storage> global_3: type_13;
@group(0) @binding(2)
var<storage> global_4: type_13;
@group(0) @binding(3)
var<storage> global_5: type_13;
@group(0) @binding(4)
var<storage> global_6: type_13;
@group(0) @binding(6)
var<storage> global_7: type_13;
@group(0) @binding(7)
var<storage, read_write> global_8: type_26;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: i32;
var local_17: i32;
var local_18: i32;
var local_19: i32;
var local_20: i32;
var local_21: i32;
var local_22: i32;
var local_23: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var local_32: i32;
var local_33: i32;
var local_34: i32;
var local_35: i32;
var local_36: i32;
var local_37: i32;
var local_38: i32;
var local_39: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var local_44: i32;
var local_45: i32;
var local_46: i32;
var local_47: i32;
var local_48: i32;
var local_49: i32;
var local_50: i32;
var local_51: i32;
var local_52: i32;
var local_53: i32;
var local_54: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var local_59: i32;
var local_60: i32;
var local_61: i32;
var local_62: i32;
var local_63: i32;
var local_64: i32;
var local_65: i32;
var local_66: i32;
var local_67: i32;
var local_68: i32;
var local_69: i32;
var local_70: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var local_74: i32;
var local_75: i32;
var local_76: i32;
var local_77: i32;
var local_78: i32;
var local_79: i32;
var local_80: i32;
var local_81: i32;
var local_82: i32;
var local_83: i32;
var local_84: i32;
var local_85: i32;
var local_86: i32;
var local_87: i32;
var local_88: i32;
var local_89: i32;
var local_90: i32;
var local_91: i32;
var local_92: i32;
var local_93: i32;
var local_94: i32;
var local_95: i32;
var local_96: i32;
var local_97: i32;
var local_98: i32;
var local_99: i32;
var local_100: i32;
var local_101: i32;
var local_102: i32;
var local_103: i32;
var local_104: f32;
var local_105: i32;
var local_106: i32;
var local_107: i32;
var local_108: i32;
var local_109: i32;
var local_110: i32;
var local_111: i32;
var local_112: i32;
var local_113: i32;
var local_114: i32;
var local_115: i32;
var local_116: i32;
var local_117: i32;
var local_118: i32;
var local_119: i32;
var local_120: i32;
var local_121: i32;
var local_122: f32;
var local_123: i32;
var local_124: i32;
var local_125: i32;
var local_126: i32;
var local_127: i32;
var local_128: i32;
var local_129: i32;
var local_130: i32;
var local_131: i32;
var local_132: f32;
var local_133: i32;
var local_134: i32;
var local_135: i32;
var local_136: i32;
var local_137: i32;
var local_138: i32;
var local_139: i32;
var local_140: i32;
var local_141: i32;
var local_142: f32;
var local_143: i32;
var local_144: i32;
var local_145: i32;
var local_146: i32;
var local_147: i32;
var local_148: i32;
var local_149: i32;
var local_150: i32;
var local_151: i32;
var local_152: i32;
var local_153: i32;
var local_154: i32;
var local_155: i32;
var local_156: i32;
var local_157: i32;
var local_158: i32;
var local_159: i32;
var local_160: i32;
var local_161: i32;
var local_162: i32;
var local_163: i32;
var local_164: i32;
var local_165: i32;
var local_166: i32;
var local_167: i32;
var local_168: i32;
var local_169: i32;
var local_170: i32;
var local_171: i32;
var local_172: i32;
var local_173: i32;
var local_174: i32;
var local_175: i32;
var local_176: i32;
var local_177: i32;
var local_178: f32;
var local_179: i32;
var local_180: i32;
var local_181: i32;
var local_182: i32;
var local_183: i32;
var local_184: i32;
var local_185: i32;
var local_186: i32;
var local_187: i32;
var local_188: i32;
var local_189: i32;
var local_190: i32;
var local_191: i32;
var local_192: i32;
var local_193: i32;
var local_194: i32;
var local_195: i32;
var local_196: f32;
var local_197: i32;
var local_198: i32;
var local_199: i32;
var local_200: i32;
var local_201: i32;
var local_202: i32;
var local_203: i32;
var local_204: i32;
var local_205: i32;
var local_206: f32;
var local_207: i32;
var local_208: i32;
var local_209: i32;
var local_210: i32;
var local_211: i32;
var local_212: i32;
var local_213: i32;
var local_214: i32;
var local_215: i32;
var local_216: i32;
var local_217: i32;
var local_218: i32;
var local_219: i32;
var local_220: i32;
var local_221: i32;
var local_222: i32;
var local_223: i32;
var local_224: i32;
var local_225: i32;
var local_226: i32;
var local_227: i32;
var phi_702_: bool;
var phi_703_: bool;
var phi_704_: bool;
var phi_1084_: type_23;
var phi_1796_: f32;
var phi_1799_: u32;
var phi_1797_: f32;
var phi_1800_: u32;
var local_228: u32;
var phi_1829_: f32;
var phi_1832_: u32;
var phi_1830_: f32;
var phi_1833_: u32;
var phi_1844_: u32;
var phi_1899_: f32;
var phi_1902_: u32;
var phi_1900_: f32;
var phi_1903_: u32;
var local_229: u32;
var phi_1932_: f32;
var phi_1935_: u32;
var phi_1933_: f32;
var phi_1936_: u32;
var phi_1947_: u32;
var phi_1948_: u32;
var phi_1999_: f32;
var phi_2002_: u32;
var phi_2000_: f32;
var phi_2003_: u32;
var local_230: u32;
var phi_2032_: f32;
var phi_2035_: u32;
var phi_2033_: f32;
var phi_2036_: u32;
var phi_2047_: u32;
var phi_2048_: u32;
var phi_2094_: type_23;
var phi_2169_: i32;
var phi_2207_: i32;
var phi_2361_: i32;
var phi_2466_: type_23;
var phi_2893_: f32;
var phi_2999_: f32;
var phi_3126_: f32;
var phi_3274_: i32;
var phi_3287_: i32;
var phi_3301_: i32;
var phi_3736_: type_23;
var phi_3969_: u32;
var phi_3999_: u32;
var phi_4029_: u32;
var phi_2362_: i32;
var phi_2208_: i32;
var phi_4078_: i32;
var phi_4232_: i32;
var phi_4337_: type_23;
var phi_4764_: f32;
var phi_4870_: f32;
var phi_4997_: f32;
var phi_5145_: i32;
var phi_5158_: i32;
var phi_5172_: i32;
var phi_5633_: type_23;
var phi_5711_: i32;
var phi_5722_: i32;
var phi_5750_: type_23;
var phi_5799_: u32;
var phi_5800_: u32;
var phi_5801_: u32;
var phi_6462_: i32;
var phi_6473_: i32;
var phi_6501_: type_23;
var phi_6550_: u32;
var phi_6551_: u32;
var phi_6552_: u32;
var phi_7213_: i32;
var phi_7224_: i32;
var phi_7252_: type_23;
var phi_7301_: u32;
var phi_7302_: u32;
var phi_7303_: u32;
var phi_7964_: i32;
var phi_7975_: i32;
var phi_8003_: type_23;
var phi_8052_: u32;
var phi_8053_: u32;
var phi_8054_: u32;
var phi_8724_: type_23;
var phi_8957_: u32;
var phi_8987_: u32;
var phi_9017_: u32;
var phi_4233_: i32;
var phi_4079_: i32;
var phi_9062_: i32;
var phi_9216_: i32;
var phi_9321_: type_23;
var phi_9748_: f32;
var phi_9854_: f32;
var phi_9981_: f32;
var phi_10129_: i32;
var phi_10142_: i32;
var phi_10156_: i32;
var phi_10615_: type_23;
var phi_10693_: i32;
var phi_10704_: i32;
var phi_10732_: type_23;
var phi_10781_: u32;
var phi_10782_: u32;
var phi_10783_: u32;
var phi_11444_: i32;
var phi_11455_: i32;
var phi_11483_: type_23;
var phi_11532_: u32;
var phi_11533_: u32;
var phi_11534_: u32;
var phi_12195_: i32;
var phi_12206_: i32;
var phi_12234_: type_23;
var phi_12283_: u32;
var phi_12284_: u32;
var phi_12285_: u32;
var phi_12946_: i32;
var phi_12957_: i32;
var phi_12985_: type_23;
var phi_13034_: u32;
var phi_13035_: u32;
var phi_13036_: u32;
var phi_13715_: type_23;
var phi_13793_: i32;
var phi_13804_: i32;
var phi_13832_: type_23;
var phi_13881_: u32;
var phi_13882_: u32;
var phi_13883_: u32;
var phi_14544_: i32;
var phi_14555_: i32;
var phi_14583_: type_23;
var phi_14632_: u32;
var phi_14633_: u32;
var phi_14634_: u32;
var phi_15295_: i32;
var phi_15306_: i32;
var phi_15334_: type_23;
var phi_15383_: u32;
var phi_15384_: u32;
var phi_15385_: u32;
var phi_16046_: i32;
var phi_16057_: i32;
var phi_16085_: type_23;
var phi_16134_: u32;
var phi_16135_: u32;
var phi_16136_: u32;
var phi_16815_: type_23;
var phi_16893_: i32;
var phi_16904_: i32;
var phi_16932_: type_23;
var phi_16981_: u32;
var phi_16982_: u32;
var phi_16983_: u32;
var phi_17644_: i32;
var phi_17655_: i32;
var phi_17683_: type_23;
var phi_17732_: u32;
var phi_17733_: u32;
var phi_17734_: u32;
var phi_18395_: i32;
var phi_18406_: i32;
var phi_18434_: type_23;
var phi_18483_: u32;
var phi_18484_: u32;
var phi_18485_: u32;
var phi_19146_: i32;
var phi_19157_: i32;
var phi_19185_: type_23;
var phi_19234_: u32;
var phi_19235_: u32;
var phi_19236_: u32;
var phi_19906_: type_23;
var phi_20139_: u32;
var phi_20169_: u32;
var phi_20199_: u32;
var phi_9217_: i32;
var phi_9063_: i32;
var phi_20265_: type_23;
var phi_20340_: i32;
var phi_20344_: type_23;
var phi_20347_: i32;
var phi_20498_: type_23;
var phi_20501_: i32;
var phi_20631_: type_23;
var phi_20680_: u32;
var phi_20681_: u32;
var phi_20682_: u32;
var phi_20808_: i32;
var phi_20819_: i32;
var phi_21242_: f32;
var phi_21348_: f32;
var phi_21475_: f32;
var phi_21623_: i32;
var phi_21636_: i32;
var phi_21650_: i32;
var phi_22106_: type_23;
var phi_22303_: u32;
var phi_22304_: u32;
var phi_22305_: u32;
var phi_22339_: u32;
var phi_22369_: u32;
var phi_22399_: u32;
var phi_22436_: type_23;
var phi_20499_: type_23;
var phi_20502_: i32;
var phi_20345_: type_23;
var phi_20348_: i32;
var local_231: type_23;
var local_232: type_23;
var phi_22453_: i32;
var phi_22488_: i32;
var phi_22642_: i32;
var phi_22747_: type_23;
var phi_23174_: f32;
var phi_23280_: f32;
var phi_23407_: f32;
var phi_23555_: i32;
var phi_23568_: i32;
var phi_23582_: i32;
var phi_24017_: type_23;
var phi_24250_: u32;
var phi_24280_: u32;
var phi_24310_: u32;
var phi_22643_: i32;
var phi_22489_: i32;
var phi_24359_: i32;
var phi_24513_: i32;
var phi_24618_: type_23;
var phi_25045_: f32;
var phi_25151_: f32;
var phi_25278_: f32;
var phi_25426_: i32;
var phi_25439_: i32;
var phi_25453_: i32;
var phi_25914_: type_23;
var phi_25992_: i32;
var phi_26003_: i32;
var phi_26031_: type_23;
var phi_26080_: u32;
var phi_26081_: u32;
var phi_26082_: u32;
var phi_26743_: i32;
var phi_26754_: i32;
var phi_26782_: type_23;
var phi_26831_: u32;
var phi_26832_: u32;
var phi_26833_: u32;
var phi_27494_: i32;
var phi_27505_: i32;
var phi_27533_: type_23;
var phi_27582_: u32;
var phi_27583_: u32;
var phi_27584_: u32;
var phi_28245_: i32;
var phi_28256_: i32;
var phi_28284_: type_23;
var phi_28333_: u32;
var phi_28334_: u32;
var phi_28335_: u32;
var phi_29005_: type_23;
var phi_29238_: u32;
var phi_29268_: u32;
var phi_29298_: u32;
var phi_24514_: i32;
var phi_24360_: i32;
var phi_29343_: i32;
var phi_29497_: i32;
var phi_29602_: type_23;
var phi_30029_: f32;
var phi_30135_: f32;
var phi_30262_: f32;
var phi_30410_: i32;
var phi_30423_: i32;
var phi_30437_: i32;
var phi_30896_: type_23;
var phi_30974_: i32;
var phi_30985_: i32;
var phi_31013_: type_23;
var phi_31062_: u32;
var phi_31063_: u32;
var phi_31064_: u32;
var phi_31725_: i32;
var phi_31736_: i32;
var phi_31764_: type_23;
var phi_31813_: u32;
var phi_31814_: u32;
var phi_31815_: u32;
var phi_32476_: i32;
var phi_32487_: i32;
var phi_32515_: type_23;
var phi_32564_: u32;
var phi_32565_: u32;
var phi_32566_: u32;
var phi_33227_: i32;
var phi_33238_: i32;
var phi_33266_: type_23;
var phi_33315_: u32;
var phi_33316_: u32;
var phi_33317_: u32;
var phi_33996_: type_23;
var phi_34074_: i32;
var phi_34085_: i32;
var phi_34113_: type_23;
var phi_34162_: u32;
var phi_34163_: u32;
var phi_34164_: u32;
var phi_34825_: i32;
var phi_34836_: i32;
var phi_34864_: type_23;
var phi_34913_: u32;
var phi_34914_: u32;
var phi_34915_: u32;
var phi_35576_: i32;
var phi_35587_: i32;
var phi_35615_: type_23;
var phi_35664_: u32;
var phi_35665_: u32;
var phi_35666_: u32;
var phi_36327_: i32;
var phi_36338_: i32;
var phi_36366_: type_23;
var phi_36415_: u32;
var phi_36416_: u32;
var phi_36417_: u32;
var phi_37096_: type_23;
var phi_37174_: i32;
var phi_37185_: i32;
var phi_37213_: type_23;
var phi_37262_: u32;
var phi_37263_: u32;
var phi_37264_: u32;
var phi_37925_: i32;
var phi_37936_: i32;
var phi_37964_: type_23;
var phi_38013_: u32;
var phi_38014_: u32;
var phi_38015_: u32;
var phi_38676_: i32;
var phi_38687_: i32;
var phi_38715_: type_23;
var phi_38764_: u32;
var phi_38765_: u32;
var phi_38766_: u32;
var phi_39427_: i32;
var phi_39438_: i32;
var phi_39466_: type_23;
var phi_39515_: u32;
var phi_39516_: u32;
var phi_39517_: u32;
var phi_40187_: type_23;
var phi_40420_: u32;
var phi_40450_: u32;
var phi_40480_: u32;
var phi_29498_: i32;
var phi_29344_: i32;
var phi_40547_: type_23;
var phi_40622_: i32;
var phi_40660_: i32;
var phi_40814_: i32;
var phi_40919_: type_23;
var phi_41346_: f32;
var phi_41591_: type_23;
var phi_41824_: u32;
var phi_41854_: u32;
var phi_41884_: u32;
var phi_40815_: i32;
var phi_40661_: i32;
var phi_41933_: i32;
var phi_42087_: i32;
var phi_42192_: type_23;
var phi_42619_: f32;
var phi_42890_: type_23;
var phi_42968_: i32;
var phi_42979_: i32;
var phi_43007_: type_23;
var phi_43056_: u32;
var phi_43057_: u32;
var phi_43058_: u32;
var phi_43719_: i32;
var phi_43730_: i32;
var phi_43758_: type_23;
var phi_43807_: u32;
var phi_43808_: u32;
var phi_43809_: u32;
var phi_44470_: i32;
var phi_44481_: i32;
var phi_44509_: type_23;
var phi_44558_: u32;
var phi_44559_: u32;
var phi_44560_: u32;
var phi_45221_: i32;
var phi_45232_: i32;
var phi_45260_: type_23;
var phi_45309_: u32;
var phi_45310_: u32;
var phi_45311_: u32;
var phi_45981_: type_23;
var phi_46214_: u32;
var phi_46244_: u32;
var phi_46274_: u32;
var phi_42088_: i32;
var phi_41934_: i32;
var phi_46319_: i32;
var phi_46473_: i32;
var phi_46578_: type_23;
var phi_47005_: f32;
var phi_47274_: type_23;
var phi_47352_: i32;
var phi_47363_: i32;
var phi_47391_: type_23;
var phi_47440_: u32;
var phi_47441_: u32;
var phi_47442_: u32;
var phi_48103_: i32;
var phi_48114_: i32;
var phi_48142_: type_23;
var phi_48191_: u32;
var phi_48192_: u32;
var phi_48193_: u32;
var phi_48854_: i32;
var phi_48865_: i32;
var phi_48893_: type_23;
var phi_48942_: u32;
var phi_48943_: u32;
var phi_48944_: u32;
var phi_49605_: i32;
var phi_49616_: i32;
var phi_49644_: type_23;
var phi_49693_: u32;
var phi_49694_: u32;
var phi_49695_: u32;
var phi_50374_: type_23;
var phi_50452_: i32;
var phi_50463_: i32;
var phi_50491_: type_23;
var phi_50540_: u32;
var phi_50541_: u32;
var phi_50542_: u32;
var phi_51203_: i32;
var phi_51214_: i32;
var phi_51242_: type_23;
var phi_51291_: u32;
var phi_51292_: u32;
var phi_51293_: u32;
var phi_51954_: i32;
var phi_51965_: i32;
var phi_51993_: type_23;
var phi_52042_: u32;
var phi_52043_: u32;
var phi_52044_: u32;
var phi_52705_: i32;
var phi_52716_: i32;
var phi_52744_: type_23;
var phi_52793_: u32;
var phi_52794_: u32;
var phi_52795_: u32;
var phi_53474_: type_23;
var phi_53552_: i32;
var phi_53563_: i32;
var phi_53591_: type_23;
var phi_53640_: u32;
var phi_53641_: u32;
var phi_53642_: u32;
var phi_54303_: i32;
var phi_54314_: i32;
var phi_54342_: type_23;
var phi_54391_: u32;
var phi_54392_: u32;
var phi_54393_: u32;
var phi_55054_: i32;
var phi_55065_: i32;
var phi_55093_: type_23;
var phi_55142_: u32;
var phi_55143_: u32;
var phi_55144_: u32;
var phi_55805_: i32;
var phi_55816_: i32;
var phi_55844_: type_23;
var phi_55893_: u32;
var phi_55894_: u32;
var phi_55895_: u32;
var phi_56565_: type_23;
var phi_56798_: u32;
var phi_56828_: u32;
var phi_56858_: u32;
var phi_46474_: i32;
var phi_46320_: i32;
var phi_56924_: type_23;
var phi_56999_: i32;
var phi_57003_: type_23;
var phi_57006_: i32;
var phi_57157_: type_23;
var phi_57160_: i32;
var phi_57290_: type_23;
var phi_57339_: u32;
var phi_57340_: u32;
var phi_57341_: u32;
var phi_57467_: i32;
var phi_57478_: i32;
var phi_57901_: f32;
var phi_58167_: type_23;
var phi_58364_: u32;
var phi_58365_: u32;
var phi_58366_: u32;
var phi_58400_: u32;
var phi_58430_: u32;
var phi_58460_: u32;
var phi_58497_: type_23;
var phi_57158_: type_23;
var phi_57161_: i32;
var phi_57004_: type_23;
var phi_57007_: i32;
var local_233: type_23;
var local_234: type_23;
var phi_58514_: i32;
var phi_58549_: i32;
var phi_58703_: i32;
var phi_58808_: type_23;
var phi_59235_: f32;
var phi_59480_: type_23;
var phi_59713_: u32;
var phi_59743_: u32;
var phi_59773_: u32;
var phi_58704_: i32;
var phi_58550_: i32;
var phi_59822_: i32;
var phi_59976_: i32;
var phi_60081_: type_23;
var phi_60508_: f32;
var phi_60779_: type_23;
var phi_60857_: i32;
var phi_60868_: i32;
var phi_60896_: type_23;
var phi_60945_: u32;
var phi_60946_: u32;
var phi_60947_: u32;
var phi_61608_: i32;
var phi_61619_: i32;
var phi_61647_: type_23;
var phi_61696_: u32;
var phi_61697_: u32;
var phi_61698_: u32;
var phi_62359_: i32;
var phi_62370_: i32;
var phi_62398_: type_23;
var phi_62447_: u32;
var phi_62448_: u32;
var phi_62449_: u32;
var phi_63110_: i32;
var phi_63121_: i32;
var phi_63149_: type_23;
var phi_63198_: u32;
var phi_63199_: u32;
var phi_63200_: u32;
var phi_63870_: type_23;
var phi_64103_: u32;
var phi_64133_: u32;
var phi_64163_: u32;
var phi_59977_: i32;
var phi_59823_: i32;
var phi_64208_: i32;
var phi_64362_: i32;
var phi_64467_: type_23;
var phi_64894_: f32;
var phi_65163_: type_23;
var phi_65241_: i32;
var phi_65252_: i32;
var phi_65280_: type_23;
var phi_65329_: u32;
var phi_65330_: u32;
var phi_65331_: u32;
var phi_65992_: i32;
var phi_66003_: i32;
var phi_66031_: type_23;
var phi_66080_: u32;
var phi_66081_: u32;
var phi_66082_: u32;
var phi_66743_: i32;
var phi_66754_: i32;
var phi_66782_: type_23;
var phi_66831_: u32;
var phi_66832_: u32;
var phi_66833_: u32;
var phi_67494_: i32;
var phi_67505_: i32;
var phi_67533_: type_23;
var phi_67582_: u32;
var phi_67583_: u32;
var phi_67584_: u32;
var phi_68263_: type_23;
var phi_68341_: i32;
var phi_68352_: i32;
var phi_68380_: type_23;
var phi_68429_: u32;
var phi_68430_: u32;
var phi_68431_: u32;
var phi_69092_: i32;
var phi_69103_: i32;
var phi_69131_: type_23;
var phi_69180_: u32;
var phi_69181_: u32;
var phi_69182_: u32;
var phi_69843_: i32;
var phi_69854_: i32;
var phi_69882_: type_23;
var phi_69931_: u32;
var phi_69932_: u32;
var phi_69933_: u32;
var phi_70594_: i32;
var phi_70605_: i32;
var phi_70633_: type_23;
var phi_70682_: u32;
var phi_70683_: u32;
var phi_70684_: u32;
var phi_71363_: type_23;
var phi_71441_: i32;
var phi_71452_: i32;
var phi_71480_: type_23;
var phi_71529_: u32;
var phi_71530_: u32;
var phi_71531_: u32;
var phi_72192_: i32;
var phi_72203_: i32;
var phi_72231_: type_23;
var phi_72280_: u32;
var phi_72281_: u32;
var phi_72282_: u32;
var phi_72943_: i32;
var phi_72954_: i32;
var phi_72982_: type_23;
var phi_73031_: u32;
var phi_73032_: u32;
var phi_73033_: u32;
var phi_73694_: i32;
var phi_73705_: i32;
var phi_73733_: type_23;
var phi_73782_: u32;
var phi_73783_: u32;
var phi_73784_: u32;
var phi_74454_: type_23;
var phi_74687_: u32;
var phi_74717_: u32;
var phi_74747_: u32;
var phi_64363_: i32;
var phi_64209_: i32;
var local_235: u32;
var local_236: u32;
var local_237: u32;
var local_238: u32;
var local_239: u32;
var local_240: u32;
var local_241: type_23;
var local_242: type_23;
let _e249 = global;
let _e259 = arrayLength((&global_5.member));
let _e262 = arrayLength((&global_6.member));
let _e265 = arrayLength((&global_2.member));
let _e268 = arrayLength((&global_7.member));
let _e270 = arrayLength((&global_8.member));
let _e273 = global_1.member.member;
if (_e249.x < _e273.member) {
if (_e249.y < _e273.member_1) {
let _e281 = bitcast<i32>(_e249.x);
let _e285 = global_1.member.member.member;
let _e286 = bitcast<i32>(_e285);
let _e290 = global_1.member.member_12.member_4;
let _e294 = global_1.member.member_12.member_7;
let _e296 = bitcast<i32>((_e290 * _e294));
let _e298 = bitcast<i32>((_e249.y * 16u));
local_225 = _e296;
local_226 = _e281;
local_227 = _e286;
let _e299 = local_225;
let _e300 = local_227;
let _e303 = local_226;
let _e304 = ((_e299 + (11i * _e300)) + _e303);
let _e306 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e308 = select(_e306, _e304, (_e304 < _e306));
let _e313 = global_4.member[bitcast<u32>(select(0i, _e308, (_e308 > 0i)))];
let _e314 = f32(_e298);
if (_e313 < _e314) {
phi_703_ = bool();
phi_704_ = true;
} else {
let _e316 = local_225;
let _e317 = local_227;
let _e320 = local_226;
let _e321 = ((_e316 + (10i * _e317)) + _e320);
let _e323 = select(_e306, _e321, (_e321 < _e306));
let _e328 = global_4.member[bitcast<u32>(select(0i, _e323, (_e323 > 0i)))];
let _e331 = (_e328 > f32((_e298 + 15i)));
if _e331 {
phi_702_ = bool();
} else {
let _e332 = local_225;
let _e333 = local_227;
let _e336 = local_226;
let _e337 = ((_e332 + (11i * _e333)) + _e336);
let _e339 = select(_e306, _e337, (_e337 < _e306));
let _e344 = global_4.member[bitcast<u32>(select(0i, _e339, (_e339 > 0i)))];
phi_702_ = (_e328 <= _e344);
}
let _e347 = phi_702_;
phi_703_ = _e347;
phi_704_ = _e331;
}
let _e349 = phi_703_;
let _e351 = phi_704_;
if select(_e349, false, _e351) {
local_222 = _e296;
local_223 = _e281;
local_224 = _e286;
let _e353 = local_222;
let _e354 = local_224;
let _e357 = local_223;
let _e358 = ((_e353 + (10i * _e354)) + _e357);
let _e360 = select(_e306, _e358, (_e358 < _e306));
let _e365 = global_4.member[bitcast<u32>(select(0i, _e360, (_e360 > 0i)))];
let _e366 = local_222;
let _e367 = local_224;
let _e370 = local_223;
let _e371 = ((_e366 + (11i * _e367)) + _e370);
let _e373 = select(_e306, _e371, (_e371 < _e306));
let _e378 = global_4.member[bitcast<u32>(select(0i, _e373, (_e373 > 0i)))];
let _e379 = local_222;
let _e380 = local_224;
let _e383 = local_223;
let _e384 = ((_e379 + (12i * _e380)) + _e383);
let _e386 = select(_e306, _e384, (_e384 < _e306));
let _e391 = global_4.member[bitcast<u32>(select(0i, _e386, (_e386 > 0i)))];
let _e392 = local_222;
let _e393 = local_224;
let _e396 = local_223;
let _e397 = ((_e392 + (13i * _e393)) + _e396);
let _e399 = select(_e306, _e397, (_e397 < _e306));
let _e404 = global_4.member[bitcast<u32>(select(0i, _e399, (_e399 > 0i)))];
local_219 = _e296;
local_220 = _e281;
local_221 = _e286;
let _e405 = local_219;
let _e406 = local_221;
let _e408 = local_220;
let _e409 = ((_e405 + _e406) + _e408);
let _e411 = select(_e306, _e409, (_e409 < _e306));
let _e416 = global_4.member[bitcast<u32>(select(0i, _e411, (_e411 > 0i)))];
let _e417 = local_219;
let _e418 = local_221;
let _e421 = local_220;
let _e422 = ((_e417 + (2i * _e418)) + _e421);
let _e424 = select(_e306, _e422, (_e422 < _e306));
let _e429 = global_4.member[bitcast<u32>(select(0i, _e424, (_e424 > 0i)))];
let _e430 = local_219;
let _e431 = local_221;
let _e434 = local_220;
let _e435 = ((_e430 + (3i * _e431)) + _e434);
let _e437 = select(_e306, _e435, (_e435 < _e306));
let _e442 = global_4.member[bitcast<u32>(select(0i, _e437, (_e437 > 0i)))];
let _e443 = local_219;
let _e444 = local_220;
let _e445 = (_e443 + _e444);
let _e447 = select(_e306, _e445, (_e445 < _e306));
let _e452 = global_4.member[bitcast<u32>(select(0i, _e447, (_e447 > 0i)))];
let _e453 = (_e452 > 0f);
let _e454 = local_219;
let _e455 = local_221;
let _e458 = local_220;
let _e459 = ((_e454 + (4i * _e455)) + _e458);
let _e461 = select(_e306, _e459, (_e459 < _e306));
let _e466 = global_4.member[bitcast<u32>(select(0i, _e461, (_e461 > 0i)))];
let _e467 = local_219;
let _e468 = local_221;
let _e471 = local_220;
let _e472 = ((_e467 + (5i * _e468)) + _e471);
let _e474 = select(_e306, _e472, (_e472 < _e306));
let _e479 = global_4.member[bitcast<u32>(select(0i, _e474, (_e474 > 0i)))];
let _e480 = local_219;
let _e481 = local_221;
let _e484 = local_220;
let _e485 = ((_e480 + (6i * _e481)) + _e484);
let _e487 = select(_e306, _e485, (_e485 < _e306));
let _e492 = global_4.member[bitcast<u32>(select(0i, _e487, (_e487 > 0i)))];
let _e493 = local_219;
let _e494 = local_221;
let _e497 = local_220;
let _e498 = ((_e493 + (7i * _e494)) + _e497);
let _e500 = select(_e306, _e498, (_e498 < _e306));
let _e505 = global_4.member[bitcast<u32>(select(0i, _e500, (_e500 > 0i)))];
let _e506 = local_219;
let _e507 = local_221;
let _e510 = local_220;
let _e511 = ((_e506 + (8i * _e507)) + _e510);
let _e513 = select(_e306, _e511, (_e511 < _e306));
let _e518 = global_4.member[bitcast<u32>(select(0i, _e513, (_e513 > 0i)))];
let _e519 = local_219;
let _e520 = local_221;
let _e523 = local_220;
let _e524 = ((_e519 + (9i * _e520)) + _e523);
let _e526 = select(_e306, _e524, (_e524 < _e306));
let _e531 = global_4.member[bitcast<u32>(select(0i, _e526, (_e526 > 0i)))];
let _e534 = bitcast<f32>((bitcast<u32>(_e429) & 2147483647u));
let _e538 = global_1.member.member_1.member;
let _e542 = global_1.member.member_1.member_1;
let _e543 = bitcast<i32>(_e538);
let _e544 = bitcast<i32>(_e542);
if _e453 {
phi_1084_ = type_23(_e544, _e543);
} else {
phi_1084_ = type_23(_e543, _e544);
}
let _e548 = phi_1084_;
let _e553 = global_1.member.member_12.member_10;
if ((_e453 != (_e553 == 1u)) || (_e298 >= _e548.member)) {
} else {
let _e561 = global_1.member.member_12.member_6;
local_216 = bitcast<i32>((_e290 * _e561));
local_217 = _e281;
local_218 = _e286;
let _e564 = local_216;
let _e565 = local_217;
let _e566 = (_e564 + _e565);
let _e568 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e570 = select(_e568, _e566, (_e566 < _e568));
let _e575 = global_3.member[bitcast<u32>(select(0i, _e570, (_e570 > 0i)))];
let _e576 = local_216;
let _e577 = local_218;
let _e579 = local_217;
let _e580 = ((_e576 + _e577) + _e579);
let _e582 = select(_e568, _e580, (_e580 < _e568));
let _e587 = global_3.member[bitcast<u32>(select(0i, _e582, (_e582 > 0i)))];
let _e588 = local_216;
let _e589 = local_218;
let _e592 = local_217;
let _e593 = ((_e588 + (2i * _e589)) + _e592);
let _e595 = select(_e568, _e593, (_e593 < _e568));
let _e600 = global_3.member[bitcast<u32>(select(0i, _e595, (_e595 > 0i)))];
let _e601 = local_216;
let _e602 = local_218;
let _e605 = local_217;
let _e606 = ((_e601 + (3i * _e602)) + _e605);
let _e608 = select(_e568, _e606, (_e606 < _e568));
let _e613 = global_3.member[bitcast<u32>(select(0i, _e608, (_e608 > 0i)))];
let _e614 = local_216;
let _e615 = local_218;
let _e618 = local_217;
let _e619 = ((_e614 + (4i * _e615)) + _e618);
let _e621 = select(_e568, _e619, (_e619 < _e568));
let _e626 = global_3.member[bitcast<u32>(select(0i, _e621, (_e621 > 0i)))];
let _e627 = local_216;
let _e628 = local_218;
let _e631 = local_217;
let _e632 = ((_e627 + (5i * _e628)) + _e631);
let _e634 = select(_e568, _e632, (_e632 < _e568));
let _e639 = global_3.member[bitcast<u32>(select(0i, _e634, (_e634 > 0i)))];
let _e640 = local_216;
let _e641 = local_218;
let _e644 = local_217;
let _e645 = ((_e640 + (18i * _e641)) + _e644);
let _e647 = select(_e568, _e645, (_e645 < _e568));
let _e652 = global_3.member[bitcast<u32>(select(0i, _e647, (_e647 > 0i)))];
let _e653 = local_216;
let _e654 = local_218;
let _e657 = local_217;
let _e658 = ((_e653 + (19i * _e654)) + _e657);
let _e660 = select(_e568, _e658, (_e658 < _e568));
let _e665 = global_3.member[bitcast<u32>(select(0i, _e660, (_e660 > 0i)))];
let _e666 = local_216;
let _e667 = local_218;
let _e670 = local_217;
let _e671 = ((_e666 + (20i * _e667)) + _e670);
let _e673 = select(_e568, _e671, (_e671 < _e568));
let _e678 = global_3.member[bitcast<u32>(select(0i, _e673, (_e673 > 0i)))];
let _e679 = local_216;
let _e680 = local_218;
let _e683 = local_217;
let _e684 = ((_e679 + (23i * _e680)) + _e683);
let _e686 = select(_e568, _e684, (_e684 < _e568));
let _e691 = global_3.member[bitcast<u32>(select(0i, _e686, (_e686 > 0i)))];
let _e692 = (_e298 + 16i);
let _e694 = (0.5f * (16f - 1f));
let _e695 = (_e314 + _e694);
let _e699 = (-(((_e416 * _e695) + _e442)) / _e429);
let _e717 = (0.5f * 1f);
let _e719 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e466 * _e695) + ((_e479 * _e699) + _e492))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e505 * _e695) + ((_e518 * _e699) + _e531))) & 2147483647u)))) / _e534) + _e717));
let _e723 = global_1.member.member_18.member_1;
phi_1796_ = 8f;
phi_1799_ = 0u;
loop {
let _e725 = phi_1796_;
let _e727 = phi_1799_;
local_228 = _e727;
local_235 = _e727;
let _e730 = ((_e727 < _e723) && (_e719 >= _e725));
if _e730 {
phi_1797_ = (_e725 * 2f);
phi_1800_ = (_e727 + 1u);
} else {
phi_1797_ = f32();
phi_1800_ = u32();
}
let _e734 = phi_1797_;
let _e736 = phi_1800_;
continue;
continuing {
phi_1796_ = _e734;
phi_1799_ = _e736;
break if !(_e730);
}
}
let _e739 = local_228;
let _e743 = f32((1i << bitcast<u32>((_e739 & 31u))));
let _e746 = f32(_e692);
if (((_e314 - _e743) > _e391) && ((_e746 + _e743) < _e404)) {
let _e25751 = local_235;
phi_1844_ = _e25751;
} else {
phi_1829_ = 8f;
phi_1832_ = 0u;
loop {
let _e752 = phi_1829_;
let _e754 = phi_1832_;
local_236 = _e754;
let _e757 = ((_e754 < _e723) && ((_e719 * 0.125f) >= _e752));
if _e757 {
phi_1830_ = (_e752 * 2f);
phi_1833_ = (_e754 + 1u);
} else {
phi_1830_ = f32();
phi_1833_ = u32();
}
let _e761 = phi_1830_;
let _e763 = phi_1833_;
continue;
continuing {
phi_1829_ = _e761;
phi_1832_ = _e763;
break if !(_e757);
}
}
let _e25753 = local_236;
phi_1844_ = _e25753;
}
let _e766 = phi_1844_;
let _e767 = (_e298 - 16i);
let _e769 = (_e365 <= _e378);
let _e770 = f32(_e767);
if ((_e767 >= 0i) && ((_e769 && (_e378 >= _e770)) && (_e365 <= f32((_e298 - 1i))))) {
let _e778 = (_e770 + _e694);
let _e782 = (-(((_e416 * _e778) + _e442)) / _e429);
let _e801 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e466 * _e778) + ((_e479 * _e782) + _e492))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e505 * _e778) + ((_e518 * _e782) + _e531))) & 2147483647u)))) / _e534) + _e717));
phi_1899_ = 8f;
phi_1902_ = 0u;
loop {
let _e803 = phi_1899_;
let _e805 = phi_1902_;
local_229 = _e805;
local_237 = _e805;
let _e808 = ((_e805 < _e723) && (_e801 >= _e803));
if _e808 {
phi_1900_ = (_e803 * 2f);
phi_1903_ = (_e805 + 1u);
} else {
phi_1900_ = f32();
phi_1903_ = u32();
}
let _e812 = phi_1900_;
let _e814 = phi_1903_;
continue;
continuing {
phi_1899_ = _e812;
phi_1902_ = _e814;
break if !(_e808);
}
}
let _e817 = local_229;
let _e821 = f32((1i << bitcast<u32>((_e817 & 31u))));
if (((_e770 - _e821) > _e391) && ((_e314 + _e821) < _e404)) {
let _e25765 = local_237;
phi_1947_ = _e25765;
} else {
phi_1932_ = 8f;
phi_1935_ = 0u;
loop {
let _e829 = phi_1932_;
let _e831 = phi_1935_;
local_238 = _e831;
let _e834 = ((_e831 < _e723) && ((_e801 * 0.125f) >= _e829));
if _e834 {
phi_1933_ = (_e829 * 2f);
phi_1936_ = (_e831 + 1u);
} else {
phi_1933_ = f32();
phi_1936_ = u32();
}
let _e838 = phi_1933_;
let _e840 = phi_1936_;
continue;
continuing {
phi_1932_ = _e838;
phi_1935_ = _e840;
break if !(_e834);
}
}
let _e25767 = local_238;
phi_1947_ = _e25767;
}
let _e843 = phi_1947_;
phi_1948_ = _e843;
} else {
phi_1948_ = _e766;
}
let _e845 = phi_1948_;
if ((_e692 < _e548.member) && ((_e769 && (_e378 >= _e746)) && (_e365 <= f32((_e298 + 31i))))) {
let _e855 = (_e746 + _e694);
let _e859 = (-(((_e416 * _e855) + _e442)) / _e429);
let _e878 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e466 * _e855) + ((_e479 * _e859) + _e492))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e505 * _e855) + ((_e518 * _e859) + _e531))) & 2147483647u)))) / _e534) + _e717));
phi_1999_ = 8f;
phi_2002_ = 0u;
loop {
let _e880 = phi_1999_;
let _e882 = phi_2002_;
local_230 = _e882;
local_239 = _e882;
let _e885 = ((_e882 < _e723) && (_e878 >= _e880));
if _e885 {
phi_2000_ = (_e880 * 2f);
phi_2003_ = (_e882 + 1u);
} else {
phi_2000_ = f32();
phi_2003_ = u32();
}
let _e889 = phi_2000_;
let _e891 = phi_2003_;
continue;
continuing {
phi_1999_ = _e889;
phi_2002_ = _e891;
break if !(_e885);
}
}
let _e894 = local_230;
let _e898 = f32((1i << bitcast<u32>((_e894 & 31u))));
if (((_e746 - _e898) > _e391) && ((f32((_e298 + 32i)) + _e898) < _e404)) {
let _e25780 = local_239;
phi_2047_ = _e25780;
} else {
phi_2032_ = 8f;
phi_2035_ = 0u;
loop {
let _e907 = phi_2032_;
let _e909 = phi_2035_;
local_240 = _e909;
let _e912 = ((_e909 < _e723) && ((_e878 * 0.125f) >= _e907));
if _e912 {
phi_2033_ = (_e907 * 2f);
phi_2036_ = (_e909 + 1u);
} else {
phi_2033_ = f32();
phi_2036_ = u32();
}
let _e916 = phi_2033_;
let _e918 = phi_2036_;
continue;
continuing {
phi_2032_ = _e916;
phi_2035_ = _e918;
break if !(_e912);
}
}
let _e25782 = local_240;
phi_2047_ = _e25782;
}
let _e921 = phi_2047_;
phi_2048_ = _e921;
} else {
phi_2048_ = _e766;
}
let _e923 = phi_2048_;
if (_e273.member_2 == 1u) {
let _e927 = global_1.member.member_1.member;
let _e930 = global_1.member.member_1.member_1;
let _e931 = bitcast<i32>(_e927);
let _e932 = bitcast<i32>(_e930);
if _e453 {
phi_2094_ = type_23(_e932, _e931);
} else {
phi_2094_ = type_23(_e931, _e932);
}
let _e936 = phi_2094_;
let _e940 = f32((_e298 + 15i));
let _e942 = select(_e940, _e378, (_e378 < _e940));
let _e944 = select(_e314, _e942, (_e942 > _e314));
let _e946 = select(_e940, _e944, (_e944 < _e940));
let _e953 = select(0i, select(select(i32(_e946), i32(-2147483648), (_e946 < -2147483600f)), 2147483647i, (_e946 > 2147483500f)), (_e946 == _e946));
let _e957 = (_e953 - select(0i, 1i, (_e946 < f32(_e953))));
let _e958 = bitcast<i32>(_e957);
let _e960 = select(_e314, _e365, (_e365 > _e314));
let _e962 = select(_e314, _e960, (_e960 > _e314));
let _e964 = select(_e940, _e962, (_e962 < _e940));
let _e971 = select(0i, select(select(i32(_e964), i32(-2147483648), (_e964 < -2147483600f)), 2147483647i, (_e964 > 2147483500f)), (_e964 == _e964));
let _e975 = (_e971 - select(0i, 1i, (_e964 < f32(_e971))));
let _e976 = bitcast<i32>(_e975);
if (_e958 < _e936.member) {
phi_2169_ = _e958;
} else {
phi_2169_ = (_e936.member - 1i);
}
let _e980 = phi_2169_;
let _e981 = (_e936.member_1 - 1i);
let _e982 = (_e766 == 0u);
if _e982 {
let _e984 = select(_e845, 0u, (_e845 == _e766));
let _e988 = select(_e923, 0u, ((_e923 == _e766) || (_e923 == _e845)));
let _e996 = ((select(0u, 1u, (_e766 > 0u)) + select(0u, 1u, (_e984 > 0u))) + select(0u, 1u, (_e988 > 0u)));
if (_e996 == 0u) {
phi_2207_ = 0i;
loop {
let _e999 = phi_2207_;
let _e1000 = (_e999 < 16i);
if _e1000 {
let _e1002 = (_e976 + (_e999 & 15i));
let _e1006 = (((f32(_e1002) + 0.5f) * 1f) - 0.5f);
let _e1010 = (-(((_e416 * _e1006) + _e442)) / _e429);
let _e1017 = bitcast<f32>((bitcast<u32>(((_e466 * _e1006) + ((_e479 * _e1010) + _e492))) & 2147483647u));
let _e1024 = bitcast<f32>((bitcast<u32>(((_e505 * _e1006) + ((_e518 * _e1010) + _e531))) & 2147483647u));
let _e1028 = (((0.5f * (_e1017 + _e1024)) / _e534) + _e717);
let _e1029 = (1f / 1f);
let _e1037 = ((((_e1010 + _e1028) + 0.5f) * _e1029) - 0.5f);
let _e1038 = f32(_e981);
let _e1039 = (0f - 1f);
let _e1041 = select(_e1039, _e1037, (_e1037 > _e1039));
let _e1043 = select(_e1038, _e1041, (_e1041 < _e1038));
let _e1050 = select(0i, select(select(i32(_e1043), i32(-2147483648), (_e1043 < -2147483600f)), 2147483647i, (_e1043 > 2147483500f)), (_e1043 == _e1043));
let _e1055 = (((((_e1010 - _e1028) + 0.5f) * _e1029) - 0.5f) + 1f);
let _e1056 = (_e1038 + 1f);
let _e1058 = select(0f, _e1055, (_e1055 > 0f));
let _e1060 = select(_e1056, _e1058, (_e1058 < _e1056));
let _e1067 = select(0i, select(select(i32(_e1060), i32(-2147483648), (_e1060 < -2147483600f)), 2147483647i, (_e1060 > 2147483500f)), (_e1060 == _e1060));
let _e1078 = ((1e-4f * 1f) * _e534);
let _e1080 = select(_e1024, _e1017, (_e1017 > _e1024));
let _e1082 = select(_e1078, _e1080, (_e1080 > _e1078));
let _e1084 = select(_e1024, _e1017, (_e1017 < _e1024));
let _e1086 = select(_e1078, _e1084, (_e1084 > _e1078));
let _e1088 = (0.5f * (_e1082 + _e1086));
let _e1089 = (0.5f / _e1086);
let _e1090 = (1f / _e1082);
phi_2361_ = 0i;
loop {
let _e1092 = phi_2361_;
let _e1094 = (((_e1067 - select(0i, 1i, (_e1060 < f32(_e1067)))) + (_e999 >> bitcast<u32>(4u))) + bitcast<i32>(_e1092));
let _e1095 = (_e1094 <= select(-1i, (_e1050 - select(0i, 1i, (_e1043 < f32(_e1050)))), (_e1002 <= _e980)));
if _e1095 {
let _e1101 = (((((f32(_e1094) + 0.5f) * 1f) - 0.5f) - _e1010) * _e534);
let _e1102 = (_e534 * 1f);
let _e1104 = (0.5f * _e1102);
let _e1105 = (_e1101 + _e1104);
let _e1106 = -(_e1105);
let _e1109 = (_e1088 - select(_e1106, _e1105, (_e1105 > _e1106)));
let _e1111 = select(0f, _e1109, (_e1109 > 0f));
let _e1113 = select(_e1086, _e1111, (_e1111 < _e1086));
let _e1116 = (_e1109 - _e1086);
let _e1120 = (((_e1113 * (_e1113 * _e1089)) + select(0f, _e1116, (_e1116 > 0f))) * _e1090);
let _e1124 = (_e1101 - _e1104);
let _e1125 = -(_e1124);
let _e1128 = (_e1088 - select(_e1125, _e1124, (_e1124 > _e1125)));
let _e1130 = select(0f, _e1128, (_e1128 > 0f));
let _e1132 = select(_e1086, _e1130, (_e1130 < _e1086));
let _e1135 = (_e1128 - _e1086);
let _e1139 = (((_e1132 * (_e1132 * _e1089)) + select(0f, _e1135, (_e1135 > 0f))) * _e1090);
if _e453 {
phi_2466_ = type_23(_e1094, _e1002);
} else {
phi_2466_ = type_23(_e1002, _e1094);
}
let _e1148 = phi_2466_;
let _e1152 = bitcast<i32>((_e927 * _e930));
local_214 = _e1152;
local_215 = ((_e1148.member_1 * _e931) + _e1148.member);
let _e1155 = local_214;
let _e1156 = local_215;
let _e1157 = (_e1155 + _e1156);
let _e1159 = (bitcast<i32>(_e259) - 1i);
let _e1161 = select(_e1159, _e1157, (_e1157 < _e1159));
let _e1166 = global_5.member[bitcast<u32>(select(0i, _e1161, (_e1161 > 0i)))];
let _e1167 = local_214;
let _e1169 = local_215;
let _e1170 = ((2i * _e1167) + _e1169);
let _e1172 = select(_e1159, _e1170, (_e1170 < _e1159));
let _e1177 = global_5.member[bitcast<u32>(select(0i, _e1172, (_e1172 > 0i)))];
let _e1178 = local_215;
let _e1180 = select(_e1159, _e1178, (_e1178 < _e1159));
let _e1185 = global_5.member[bitcast<u32>(select(0i, _e1180, (_e1180 > 0i)))];
let _e1186 = local_215;
let _e1197 = global_1.member.member_2.member;
let _e1198 = (((((f32(_e1148.member) + 0.5f) / f32(_e931)) * 2f) - 1f) * _e1197);
let _e1205 = global_1.member.member_2.member_1;
let _e1206 = ((1f - (((f32(_e1148.member_1) + 0.5f) / f32(_e932)) * 2f)) * _e1205);
let _e1208 = global_1.member.member_3;
let _e1216 = global_1.member.member_4;
let _e1223 = ((_e1208.member * _e1198) + (_e1216.member * _e1206));
let _e1224 = ((_e1208.member_1 * _e1198) + (_e1216.member_1 * _e1206));
let _e1225 = ((_e1208.member_2 * _e1198) + (_e1216.member_2 * _e1206));
let _e1228 = global_1.member.member_2.member_3;
let _e1229 = (_e1228 != 0u);
let _e1231 = global_1.member.member_5;
let _e1238 = select((_e1231.member + _e1223), _e1231.member, _e1229);
let _e1239 = select((_e1231.member_1 + _e1224), _e1231.member_1, _e1229);
let _e1240 = select((_e1231.member_2 + _e1225), _e1231.member_2, _e1229);
let _e1242 = global_1.member.member_6;
let _e1249 = select(_e1242.member, (_e1242.member + _e1223), _e1229);
let _e1250 = select(_e1242.member_1, (_e1242.member_1 + _e1224), _e1229);
let _e1251 = select(_e1242.member_2, (_e1242.member_2 + _e1225), _e1229);
let _e1256 = (((_e1238 * _e1238) + (_e1239 * _e1239)) + (_e1240 * _e1240));
let _e1259 = sqrt(select(0f, _e1256, (_e1256 > 0f)));
let _e1260 = (1f / _e1259);
let _e1261 = (_e1238 * _e1260);
let _e1262 = (_e1239 * _e1260);
let _e1263 = (_e1240 * _e1260);
let _e1264 = (_e575 - _e1249);
let _e1265 = (_e587 - _e1250);
let _e1266 = (_e600 - _e1251);
let _e1271 = (((_e1264 * _e1261) + (_e1265 * _e1262)) + (_e1266 * _e1263));
let _e1276 = (((_e1264 * _e613) + (_e1265 * _e626)) + (_e1266 * _e639));
let _e1281 = (((_e1261 * _e613) + (_e1262 * _e626)) + (_e1263 * _e639));
let _e1284 = ((_e1262 * _e639) - (_e1263 * _e626));
let _e1287 = ((_e1263 * _e613) - (_e1261 * _e639));
let _e1290 = ((_e1261 * _e626) - (_e1262 * _e613));
let _e1295 = (((_e1284 * _e1284) + (_e1287 * _e1287)) + (_e1290 * _e1290));
let _e1298 = (1f / select(1e-9f, _e1295, (_e1295 > 1e-9f)));
let _e1301 = ((_e1271 - (_e1281 * _e1276)) * _e1298);
let _e1304 = (((_e1281 * _e1271) - _e1276) * _e1298);
let _e1310 = -(_e1281);
let _e1313 = global_1.member.member_13.member_2;
let _e1314 = (_e1313 * _e1313);
let _e1318 = ((1f + _e1314) - ((2f * _e1313) * _e1310));
let _e1320 = select(1e-9f, _e1318, (_e1318 > 1e-9f));
let _e1332 = global_1.member.member_13.member_3;
if (_e1332 == 2u) {
let _e1337 = (0.5f - (0.5f * _e1310));
let _e1339 = select(0f, _e1337, (_e1337 > 0f));
let _e1343 = (sqrt(select(0f, _e1339, (_e1339 > 0f))) * 255f);
let _e1344 = (255f - 1f);
let _e1346 = select(0f, _e1343, (_e1343 > 0f));
let _e1348 = select(_e1344, _e1346, (_e1346 < _e1344));
let _e1355 = select(0i, select(select(i32(_e1348), i32(-2147483648), (_e1348 < -2147483600f)), 2147483647i, (_e1348 > 2147483500f)), (_e1348 == _e1348));
let _e1359 = (_e1355 - select(0i, 1i, (_e1348 < f32(_e1355))));
let _e1362 = global_1.member.member_13.member_11;
let _e1363 = bitcast<i32>(_e1362);
let _e1364 = (_e1363 + _e1359);
let _e1366 = (bitcast<i32>(_e265) - 1i);
let _e1368 = select(_e1366, _e1364, (_e1364 < _e1366));
let _e1373 = global_2.member[bitcast<u32>(select(0i, _e1368, (_e1368 > 0i)))];
let _e1375 = (_e1363 + (_e1359 + 1i));
let _e1377 = select(_e1366, _e1375, (_e1375 < _e1366));
let _e1382 = global_2.member[bitcast<u32>(select(0i, _e1377, (_e1377 > 0i)))];
phi_2893_ = (_e1373 + ((_e1382 - _e1373) * (_e1343 - f32(_e1359))));
} else {
phi_2893_ = select(((1f - _e1314) / (_e1320 * sqrt(select(0f, _e1320, (_e1320 > 0f))))), (0.75f * (1f + (_e1310 * _e1310))), (_e1332 == 1u));
}
let _e1389 = phi_2893_;
let _e1395 = global_1.member.member_12.member_12;
let _e1398 = global_1.member.member_12.member_4;
let _e1401 = global_1.member.member_12.member_13;
let _e1407 = global_1.member.member.member;
let _e1409 = (_e1304 / _e691);
local_211 = bitcast<i32>((_e1395 + (_e1398 * _e1401)));
local_212 = _e281;
local_213 = bitcast<i32>(_e1407);
let _e1412 = global_1.member.member_13.member_6;
let _e1413 = f32(_e1412);
let _e1415 = select(0f, _e1409, (_e1409 > 0f));
let _e1418 = (select(1f, _e1415, (_e1415 < 1f)) * _e1413);
let _e1419 = (_e1413 - 1f);
let _e1421 = select(0f, _e1419, (_e1419 > 0f));
let _e1423 = select(0f, _e1418, (_e1418 > 0f));
let _e1425 = select(_e1421, _e1423, (_e1423 < _e1421));
let _e1432 = select(0i, select(select(i32(_e1425), i32(-2147483648), (_e1425 < -2147483600f)), 2147483647i, (_e1425 > 2147483500f)), (_e1425 == _e1425));
let _e1436 = (_e1432 - select(0i, 1i, (_e1425 < f32(_e1432))));
if (_e1436 > 0i) {
let _e1439 = local_211;
let _e1440 = local_213;
let _e1443 = local_212;
let _e1444 = ((_e1439 + ((_e1436 - 1i) * _e1440)) + _e1443);
let _e1446 = (bitcast<i32>(_e268) - 1i);
let _e1448 = select(_e1446, _e1444, (_e1444 < _e1446));
let _e1453 = global_7.member[bitcast<u32>(select(0i, _e1448, (_e1448 > 0i)))];
phi_2999_ = _e1453;
} else {
phi_2999_ = 0f;
}
let _e1455 = phi_2999_;
let _e1456 = local_211;
let _e1457 = local_213;
let _e1460 = local_212;
let _e1461 = ((_e1456 + (_e1436 * _e1457)) + _e1460);
let _e1463 = (bitcast<i32>(_e268) - 1i);
let _e1465 = select(_e1463, _e1461, (_e1461 < _e1463));
let _e1470 = global_7.member[bitcast<u32>(select(0i, _e1465, (_e1465 > 0i)))];
let _e1477 = (_e1177 - _e1166);
let _e1480 = ((_e1301 - _e1166) / select(1e-9f, _e1477, (_e1477 > 1e-9f)));
local_208 = 0i;
local_209 = _e1186;
local_210 = _e1152;
let _e1482 = select(0f, _e1480, (_e1480 > 0f));
let _e1485 = (select(1f, _e1482, (_e1482 < 1f)) * _e1413);
let _e1487 = select(0f, _e1485, (_e1485 > 0f));
let _e1489 = select(_e1421, _e1487, (_e1487 < _e1421));
let _e1496 = select(0i, select(select(i32(_e1489), i32(-2147483648), (_e1489 < -2147483600f)), 2147483647i, (_e1489 > 2147483500f)), (_e1489 == _e1489));
let _e1500 = (_e1496 - select(0i, 1i, (_e1489 < f32(_e1496))));
if (_e1500 > 0i) {
let _e1503 = local_208;
let _e1504 = local_210;
let _e1507 = local_209;
let _e1508 = ((_e1503 + ((_e1500 - 1i) * _e1504)) + _e1507);
let _e1510 = select(_e1463, _e1508, (_e1508 < _e1463));
let _e1515 = global_7.member[bitcast<u32>(select(0i, _e1510, (_e1510 > 0i)))];
phi_3126_ = _e1515;
} else {
phi_3126_ = 0f;
}
let _e1517 = phi_3126_;
let _e1518 = local_208;
let _e1519 = local_210;
let _e1522 = local_209;
let _e1523 = ((_e1518 + (_e1500 * _e1519)) + _e1522);
let _e1525 = select(_e1463, _e1523, (_e1523 < _e1463));
let _e1530 = global_7.member[bitcast<u32>(select(0i, _e1525, (_e1525 > 0i)))];
let _e1536 = ((_e1455 + ((_e1470 - _e1455) * (_e1418 - f32(_e1436)))) + (_e1517 + ((_e1530 - _e1517) * (_e1485 - f32(_e1500)))));
let _e1545 = global_1.member.member_13.member_7;
let _e1546 = bitcast<i32>(_e1545);
let _e1549 = global_1.member.member_13.member_8;
let _e1550 = bitcast<i32>(_e1549);
let _e1553 = global_1.member.member_13.member_9;
let _e1554 = bitcast<i32>(_e1553);
let _e1557 = global_1.member.member_13.member_4;
let _e1563 = global_1.member.member_13.member_5;
let _e1567 = f32(_e1546);
let _e1572 = (((((_e1249 + (_e1261 * _e1301)) - _e1557.member) / (_e1563.member - _e1557.member)) * _e1567) - 0.5f);
let _e1573 = (_e1567 - 1f);
let _e1575 = select(0f, _e1572, (_e1572 > 0f));
let _e1577 = select(_e1573, _e1575, (_e1575 < _e1573));
let _e1578 = f32(_e1550);
let _e1583 = (((((_e1250 + (_e1262 * _e1301)) - _e1557.member_1) / (_e1563.member_1 - _e1557.member_1)) * _e1578) - 0.5f);
let _e1584 = (_e1578 - 1f);
let _e1586 = select(0f, _e1583, (_e1583 > 0f));
let _e1588 = select(_e1584, _e1586, (_e1586 < _e1584));
let _e1589 = f32(_e1554);
let _e1594 = (((((_e1251 + (_e1263 * _e1301)) - _e1557.member_2) / (_e1563.member_2 - _e1557.member_2)) * _e1589) - 0.5f);
let _e1595 = (_e1589 - 1f);
let _e1597 = select(0f, _e1594, (_e1594 > 0f));
let _e1599 = select(_e1595, _e1597, (_e1597 < _e1595));
let _e1601 = select(0f, _e1577, (_e1577 > 0f));
let _e1603 = select(1e6f, _e1601, (_e1601 < 1e6f));
let _e1610 = select(0i, select(select(i32(_e1603), i32(-2147483648), (_e1603 < -2147483600f)), 2147483647i, (_e1603 > 2147483500f)), (_e1603 == _e1603));
let _e1614 = (_e1610 - select(0i, 1i, (_e1603 < f32(_e1610))));
let _e1616 = select(0f, _e1588, (_e1588 > 0f));
let _e1618 = select(1e6f, _e1616, (_e1616 < 1e6f));
let _e1625 = select(0i, select(select(i32(_e1618), i32(-2147483648), (_e1618 < -2147483600f)), 2147483647i, (_e1618 > 2147483500f)), (_e1618 == _e1618));
let _e1629 = (_e1625 - select(0i, 1i, (_e1618 < f32(_e1625))));
let _e1631 = select(0f, _e1599, (_e1599 > 0f));
let _e1633 = select(1e6f, _e1631, (_e1631 < 1e6f));
let _e1640 = select(0i, select(select(i32(_e1633), i32(-2147483648), (_e1633 < -2147483600f)), 2147483647i, (_e1633 > 2147483500f)), (_e1633 == _e1633));
let _e1644 = (_e1640 - select(0i, 1i, (_e1633 < f32(_e1640))));
let _e1648 = (_e1588 - f32(_e1629));
let _e1650 = (_e1599 - f32(_e1644));
local_206 = (_e1577 - f32(_e1614));
let _e1651 = (_e1614 + 1i);
let _e1653 = select(_e1651, 0i, (_e1651 < 0i));
if (_e1653 >= _e1546) {
phi_3274_ = (_e1546 - 1i);
} else {
phi_3274_ = _e1653;
}
let _e1657 = phi_3274_;
local_207 = (_e1657 - _e1614);
let _e1659 = (_e1629 + 1i);
let _e1661 = select(_e1659, 0i, (_e1659 < 0i));
if (_e1661 >= _e1550) {
phi_3287_ = (_e1550 - 1i);
} else {
phi_3287_ = _e1661;
}
let _e1665 = phi_3287_;
let _e1667 = ((_e1665 - _e1629) * _e1546);
let _e1668 = (_e1644 + 1i);
let _e1670 = select(_e1668, 0i, (_e1668 < 0i));
if (_e1670 >= _e1554) {
phi_3301_ = (_e1554 - 1i);
} else {
phi_3301_ = _e1670;
}
let _e1674 = phi_3301_;
let _e1680 = global_1.member.member_13.member_10;
let _e1686 = ((bitcast<i32>(_e1680) + (((_e1644 * _e1550) + _e1629) * _e1546)) + _e1614);
let _e1688 = (bitcast<i32>(_e265) - 1i);
let _e1690 = select(_e1688, _e1686, (_e1686 < _e1688));
let _e1695 = global_2.member[bitcast<u32>(select(0i, _e1690, (_e1690 > 0i)))];
let _e1696 = local_206;
let _e1699 = local_207;
let _e1700 = (_e1686 + _e1699);
let _e1702 = select(_e1688, _e1700, (_e1700 < _e1688));
let _e1707 = global_2.member[bitcast<u32>(select(0i, _e1702, (_e1702 > 0i)))];
let _e1708 = local_206;
let _e1711 = (1f - _e1648);
let _e1713 = (_e1686 + _e1667);
let _e1715 = select(_e1688, _e1713, (_e1713 < _e1688));
let _e1720 = global_2.member[bitcast<u32>(select(0i, _e1715, (_e1715 > 0i)))];
let _e1721 = local_206;
let _e1724 = local_207;
let _e1725 = (_e1713 + _e1724);
let _e1727 = select(_e1688, _e1725, (_e1725 < _e1688));
let _e1732 = global_2.member[bitcast<u32>(select(0i, _e1727, (_e1727 > 0i)))];
let _e1733 = local_206;
let _e1738 = (_e1686 + (((_e1674 - _e1644) * _e1546) * _e1550));
let _e1740 = select(_e1688, _e1738, (_e1738 < _e1688));
let _e1745 = global_2.member[bitcast<u32>(select(0i, _e1740, (_e1740 > 0i)))];
let _e1746 = local_206;
let _e1749 = local_207;
let _e1750 = (_e1738 + _e1749);
let _e1752 = select(_e1688, _e1750, (_e1750 < _e1688));
let _e1757 = global_2.member[bitcast<u32>(select(0i, _e1752, (_e1752 > 0i)))];
let _e1758 = local_206;
let _e1762 = (_e1738 + _e1667);
let _e1764 = select(_e1688, _e1762, (_e1762 < _e1688));
let _e1769 = global_2.member[bitcast<u32>(select(0i, _e1764, (_e1764 > 0i)))];
let _e1770 = local_206;
let _e1773 = local_207;
let _e1774 = (_e1762 + _e1773);
let _e1776 = select(_e1688, _e1774, (_e1774 < _e1688));
let _e1781 = global_2.member[bitcast<u32>(select(0i, _e1776, (_e1776 > 0i)))];
let _e1782 = local_206;
let _e1791 = ((_e1259 * (_e1389 * (0.25f / 3.1415927f))) * ((((((_e1695 * (1f - _e1696)) + (_e1707 * _e1708)) * _e1711) + (((_e1720 * (1f - _e1721)) + (_e1732 * _e1733)) * _e1648)) * (1f - _e1650)) + (((((_e1745 * (1f - _e1746)) + (_e1757 * _e1758)) * _e1711) + (((_e1769 * (1f - _e1770)) + (_e1781 * _e1782)) * _e1648)) * _e1650)));
let _e1794 = global_1.member.member_13.member_1;
let _e1803 = global_1.member.member_13.member;
let _e1808 = -((_e1803.member * _e1536));
let _e1810 = select(-87f, _e1808, (_e1808 > -87f));
let _e1812 = select(88f, _e1810, (_e1810 < 88f));
let _e1814 = ((_e1812 * 1.442695f) + 0.5f);
let _e1816 = select(-127f, _e1814, (_e1814 > -127f));
let _e1818 = select(128f, _e1816, (_e1816 < 128f));
let _e1825 = select(0i, select(select(i32(_e1818), i32(-2147483648), (_e1818 < -2147483600f)), 2147483647i, (_e1818 > 2147483500f)), (_e1818 == _e1818));
let _e1829 = (_e1825 - select(0i, 1i, (_e1818 < f32(_e1825))));
let _e1830 = f32(_e1829);
let _e1834 = ((_e1812 - (_e1830 * 0.6933594f)) - (_e1830 * -2.1219444e-4f));
let _e1856 = -((_e1803.member_1 * _e1536));
let _e1858 = select(-87f, _e1856, (_e1856 > -87f));
let _e1860 = select(88f, _e1858, (_e1858 < 88f));
let _e1862 = ((_e1860 * 1.442695f) + 0.5f);
let _e1864 = select(-127f, _e1862, (_e1862 > -127f));
let _e1866 = select(128f, _e1864, (_e1864 < 128f));
let _e1873 = select(0i, select(select(i32(_e1866), i32(-2147483648), (_e1866 < -2147483600f)), 2147483647i, (_e1866 > 2147483500f)), (_e1866 == _e1866));
let _e1877 = (_e1873 - select(0i, 1i, (_e1866 < f32(_e1873))));
let _e1878 = f32(_e1877);
let _e1882 = ((_e1860 - (_e1878 * 0.6933594f)) - (_e1878 * -2.1219444e-4f));
let _e1904 = -((_e1803.member_2 * _e1536));
let _e1906 = select(-87f, _e1904, (_e1904 > -87f));
let _e1908 = select(88f, _e1906, (_e1906 < 88f));
let _e1910 = ((_e1908 * 1.442695f) + 0.5f);
let _e1912 = select(-127f, _e1910, (_e1910 > -127f));
let _e1914 = select(128f, _e1912, (_e1912 < 128f));
let _e1921 = select(0i, select(select(i32(_e1914), i32(-2147483648), (_e1914 < -2147483600f)), 2147483647i, (_e1914 > 2147483500f)), (_e1914 == _e1914));
let _e1925 = (_e1921 - select(0i, 1i, (_e1914 < f32(_e1921))));
let _e1926 = f32(_e1925);
let _e1930 = ((_e1908 - (_e1926 * 0.6933594f)) - (_e1926 * -2.1219444e-4f));
let _e1957 = select(0f, _e1301, (((_e1304 >= 0f) && (_e1304 < _e691)) && (_e1301 > 0f)));
if _e453 {
phi_3736_ = type_23(_e1094, _e1002);
} else {
phi_3736_ = type_23(_e1002, _e1094);
}
let _e1968 = phi_3736_;
let _e1971 = (_e1095 && (((_e1957 > 0f) && (_e1957 < _e1185)) && true));
let _e1974 = global_1.member.member_18.member;
let _e1975 = (((select(_e1120, (1f - _e1120), (_e1105 >= 0f)) - select(_e1139, (1f - _e1139), (_e1124 >= 0f))) * (1f / _e1102)) * _e1974);
let _e1979 = select(0f, (((((_e652 * _e1794.member) * ((1f + (_e1834 * (1f + (_e1834 * (0.5f + (_e1834 * (0.16666667f + (_e1834 * (0.041666668f + (_e1834 * (0.008333334f + (_e1834 * (0.001388889f + (_e1834 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1829 + 127i)) << bitcast<u32>(23i))))) * _e1791) * 1f) * _e1975), _e1971);
let _e1980 = select(0f, (((((_e665 * _e1794.member_1) * ((1f + (_e1882 * (1f + (_e1882 * (0.5f + (_e1882 * (0.16666667f + (_e1882 * (0.041666668f + (_e1882 * (0.008333334f + (_e1882 * (0.001388889f + (_e1882 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1877 + 127i)) << bitcast<u32>(23i))))) * _e1791) * 1f) * _e1975), _e1971);
let _e1981 = select(0f, (((((_e678 * _e1794.member_2) * ((1f + (_e1930 * (1f + (_e1930 * (0.5f + (_e1930 * (0.16666667f + (_e1930 * (0.041666668f + (_e1930 * (0.008333334f + (_e1930 * (0.001388889f + (_e1930 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1925 + 127i)) << bitcast<u32>(23i))))) * _e1791) * 1f) * _e1975), _e1971);
let _e1985 = (bitcast<f32>((bitcast<u32>(_e1979) & 2147483647u)) >= 1073741800f);
let _e1986 = (1f / 1048576f);
let _e1989 = ((_e1979 * select(1f, _e1986, _e1985)) + 0.5f);
let _e1991 = select(-1073741800f, _e1989, (_e1989 > -1073741800f));
let _e1993 = select(1073741800f, _e1991, (_e1991 < 1073741800f));
let _e2000 = select(0i, select(select(i32(_e1993), i32(-2147483648), (_e1993 < -2147483600f)), 2147483647i, (_e1993 > 2147483500f)), (_e1993 == _e1993));
let _e2004 = (_e2000 - select(0i, 1i, (_e1993 < f32(_e2000))));
let _e2005 = select(0i, 20i, _e1985);
let _e2009 = (bitcast<u32>(_e2004) << bitcast<u32>((_e2005 & 31i)));
let _e2016 = bitcast<u32>(((_e2004 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e2005) & 31i))));
let _e2020 = (bitcast<f32>((bitcast<u32>(_e1980) & 2147483647u)) >= 1073741800f);
let _e2023 = ((_e1980 * select(1f, _e1986, _e2020)) + 0.5f);
let _e2025 = select(-1073741800f, _e2023, (_e2023 > -1073741800f));
let _e2027 = select(1073741800f, _e2025, (_e2025 < 1073741800f));
let _e2034 = select(0i, select(select(i32(_e2027), i32(-2147483648), (_e2027 < -2147483600f)), 2147483647i, (_e2027 > 2147483500f)), (_e2027 == _e2027));
let _e2038 = (_e2034 - select(0i, 1i, (_e2027 < f32(_e2034))));
let _e2039 = select(0i, 20i, _e2020);
let _e2043 = (bitcast<u32>(_e2038) << bitcast<u32>((_e2039 & 31i)));
let _e2050 = bitcast<u32>(((_e2038 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e2039) & 31i))));
let _e2054 = (bitcast<f32>((bitcast<u32>(_e1981) & 2147483647u)) >= 1073741800f);
let _e2057 = ((_e1981 * select(1f, _e1986, _e2054)) + 0.5f);
let _e2059 = select(-1073741800f, _e2057, (_e2057 > -1073741800f));
let _e2061 = select(1073741800f, _e2059, (_e2059 < 1073741800f));
let _e2068 = select(0i, select(select(i32(_e2061), i32(-2147483648), (_e2061 < -2147483600f)), 2147483647i, (_e2061 > 2147483500f)), (_e2061 == _e2061));
let _e2072 = (_e2068 - select(0i, 1i, (_e2061 < f32(_e2068))));
let _e2073 = select(0i, 20i, _e2054);
let _e2077 = (bitcast<u32>(_e2072) << bitcast<u32>((_e2073 & 31i)));
let _e2084 = bitcast<u32>(((_e2072 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e2073) & 31i))));
let _e2089 = bitcast<i32>(bitcast<u32>((((_e1968.member_1 * _e931) + _e1968.member) * 6i)));
if ((_e2009 | _e2016) == 0u) {
} else {
let _e2092 = bitcast<u32>(_e2089);
if (_e2092 < _e270) {
let _e2096 = atomicAdd((&global_8.member[_e2092]), _e2009);
phi_3969_ = _e2096;
} else {
phi_3969_ = 0u;
}
let _e2098 = phi_3969_;
let _e2102 = (_e2016 + select(0u, 1u, ((_e2098 + _e2009) < _e2009)));
if (_e2102 == 0u) {
} else {
let _e2104 = (_e2092 + 1u);
if (_e2104 < _e270) {
let _e2108 = atomicAdd((&global_8.member[_e2104]), _e2102);
}
}
}
if ((_e2043 | _e2050) == 0u) {
} else {
let _e2112 = bitcast<u32>((_e2089 + 2i));
if (_e2112 < _e270) {
let _e2116 = atomicAdd((&global_8.member[_e2112]), _e2043);
phi_3999_ = _e2116;
} else {
phi_3999_ = 0u;
}
let _e2118 = phi_3999_;
let _e2122 = (_e2050 + select(0u, 1u, ((_e2118 + _e2043) < _e2043)));
if (_e2122 == 0u) {
} else {
let _e2124 = (_e2112 + 1u);
if (_e2124 < _e270) {
let _e2128 = atomicAdd((&global_8.member[_e2124]), _e2122);
}
}
}
if ((_e2077 | _e2084) == 0u) {
} else {
let _e2132 = bitcast<u32>((_e2089 + 4i));
if (_e2132 < _e270) {
let _e2136 = atomicAdd((&global_8.member[_e2132]), _e2077);
phi_4029_ = _e2136;
} else {
phi_4029_ = 0u;
}
let _e2138 = phi_4029_;
let _e2142 = (_e2084 + select(0u, 1u, ((_e2138 + _e2077) < _e2077)));
if (_e2142 == 0u) {
} else {
let _e2144 = (_e2132 + 1u);
if (_e2144 < _e270) {
let _e2148 = atomicAdd((&global_8.member[_e2144]), _e2142);
}
}
}
phi_2362_ = (_e1092 + 1i);
} else {
phi_2362_ = i32();
}
let _e2151 = phi_2362_;
continue;
continuing {
phi_2361_ = _e2151;
break if !(_e1095);
}
}
phi_2208_ = (_e999 + 1i);
} else {
phi_2208_ = i32();
}
let _e2155 = phi_2208_;
continue;
continuing {
phi_2207_ = _e2155;
break if !(_e1000);
}
}
} else {
if (_e996 == 1u) {
phi_4078_ = 0i;
loop {
let _e2159 = phi_4078_;
let _e2160 = (_e2159 < 16i);
if _e2160 {
let _e2162 = (_e976 + (_e2159 & 15i));
let _e2164 = (f32(_e2162) + 0.5f);
let _e2166 = ((_e2164 * 1f) - 0.5f);
let _e2170 = (-(((_e416 * _e2166) + _e442)) / _e429);
let _e2177 = bitcast<f32>((bitcast<u32>(((_e466 * _e2166) + ((_e479 * _e2170) + _e492))) & 2147483647u));
let _e2184 = bitcast<f32>((bitcast<u32>(((_e505 * _e2166) + ((_e518 * _e2170) + _e531))) & 2147483647u));
let _e2188 = (((0.5f * (_e2177 + _e2184)) / _e534) + _e717);
let _e2189 = (1f / 1f);
let _e2197 = ((((_e2170 + _e2188) + 0.5f) * _e2189) - 0.5f);
let _e2198 = f32(_e981);
let _e2199 = (0f - 1f);
let _e2201 = select(_e2199, _e2197, (_e2197 > _e2199));
let _e2203 = select(_e2198, _e2201, (_e2201 < _e2198));
let _e2210 = select(0i, select(select(i32(_e2203), i32(-2147483648), (_e2203 < -2147483600f)), 2147483647i, (_e2203 > 2147483500f)), (_e2203 == _e2203));
let _e2215 = (((((_e2170 - _e2188) + 0.5f) * _e2189) - 0.5f) + 1f);
let _e2216 = (_e2198 + 1f);
let _e2218 = select(0f, _e2215, (_e2215 > 0f));
let _e2220 = select(_e2216, _e2218, (_e2218 < _e2216));
let _e2227 = select(0i, select(select(i32(_e2220), i32(-2147483648), (_e2220 < -2147483600f)), 2147483647i, (_e2220 > 2147483500f)), (_e2220 == _e2220));
let _e2238 = ((1e-4f * 1f) * _e534);
let _e2240 = select(_e2184, _e2177, (_e2177 > _e2184));
let _e2242 = select(_e2238, _e2240, (_e2240 > _e2238));
let _e2244 = select(_e2184, _e2177, (_e2177 < _e2184));
let _e2246 = select(_e2238, _e2244, (_e2244 > _e2238));
let _e2248 = (0.5f * (_e2242 + _e2246));
let _e2249 = (0.5f / _e2246);
let _e2250 = (1f / _e2242);
phi_4232_ = 0i;
loop {
let _e2252 = phi_4232_;
let _e2254 = (((_e2227 - select(0i, 1i, (_e2220 < f32(_e2227)))) + (_e2159 >> bitcast<u32>(4u))) + bitcast<i32>(_e2252));
let _e2255 = (_e2254 <= select(-1i, (_e2210 - select(0i, 1i, (_e2203 < f32(_e2210)))), (_e2162 <= _e980)));
if _e2255 {
let _e2257 = (f32(_e2254) + 0.5f);
let _e2261 = ((((_e2257 * 1f) - 0.5f) - _e2170) * _e534);
let _e2262 = (_e534 * 1f);
let _e2264 = (0.5f * _e2262);
let _e2265 = (_e2261 + _e2264);
let _e2266 = -(_e2265);
let _e2269 = (_e2248 - select(_e2266, _e2265, (_e2265 > _e2266)));
let _e2271 = select(0f, _e2269, (_e2269 > 0f));
let _e2273 = select(_e2246, _e2271, (_e2271 < _e2246));
let _e2276 = (_e2269 - _e2246);
let _e2280 = (((_e2273 * (_e2273 * _e2249)) + select(0f, _e2276, (_e2276 > 0f))) * _e2250);
let _e2284 = (_e2261 - _e2264);
let _e2285 = -(_e2284);
let _e2288 = (_e2248 - select(_e2285, _e2284, (_e2284 > _e2285)));
let _e2290 = select(0f, _e2288, (_e2288 > 0f));
let _e2292 = select(_e2246, _e2290, (_e2290 < _e2246));
let _e2295 = (_e2288 - _e2246);
let _e2299 = (((_e2292 * (_e2292 * _e2249)) + select(0f, _e2295, (_e2295 > 0f))) * _e2250);
if _e453 {
phi_4337_ = type_23(_e2254, _e2162);
} else {
phi_4337_ = type_23(_e2162, _e2254);
}
let _e2308 = phi_4337_;
let _e2312 = bitcast<i32>((_e927 * _e930));
local_204 = _e2312;
local_205 = ((_e2308.member_1 * _e931) + _e2308.member);
let _e2315 = local_204;
let _e2316 = local_205;
let _e2317 = (_e2315 + _e2316);
let _e2319 = (bitcast<i32>(_e259) - 1i);
let _e2321 = select(_e2319, _e2317, (_e2317 < _e2319));
let _e2326 = global_5.member[bitcast<u32>(select(0i, _e2321, (_e2321 > 0i)))];
let _e2327 = local_204;
let _e2329 = local_205;
let _e2330 = ((2i * _e2327) + _e2329);
let _e2332 = select(_e2319, _e2330, (_e2330 < _e2319));
let _e2337 = global_5.member[bitcast<u32>(select(0i, _e2332, (_e2332 > 0i)))];
let _e2338 = local_205;
let _e2340 = select(_e2319, _e2338, (_e2338 < _e2319));
let _e2345 = global_5.member[bitcast<u32>(select(0i, _e2340, (_e2340 > 0i)))];
let _e2346 = local_205;
let _e2349 = f32(_e931);
let _e2350 = f32(_e932);
let _e2357 = global_1.member.member_2.member;
let _e2358 = (((((f32(_e2308.member) + 0.5f) / _e2349) * 2f) - 1f) * _e2357);
let _e2365 = global_1.member.member_2.member_1;
let _e2366 = ((1f - (((f32(_e2308.member_1) + 0.5f) / _e2350) * 2f)) * _e2365);
let _e2368 = global_1.member.member_3;
let _e2376 = global_1.member.member_4;
let _e2383 = ((_e2368.member * _e2358) + (_e2376.member * _e2366));
let _e2384 = ((_e2368.member_1 * _e2358) + (_e2376.member_1 * _e2366));
let _e2385 = ((_e2368.member_2 * _e2358) + (_e2376.member_2 * _e2366));
let _e2388 = global_1.member.member_2.member_3;
let _e2389 = (_e2388 != 0u);
let _e2391 = global_1.member.member_5;
let _e2398 = select((_e2391.member + _e2383), _e2391.member, _e2389);
let _e2399 = select((_e2391.member_1 + _e2384), _e2391.member_1, _e2389);
let _e2400 = select((_e2391.member_2 + _e2385), _e2391.member_2, _e2389);
let _e2402 = global_1.member.member_6;
let _e2409 = select(_e2402.member, (_e2402.member + _e2383), _e2389);
let _e2410 = select(_e2402.member_1, (_e2402.member_1 + _e2384), _e2389);
let _e2411 = select(_e2402.member_2, (_e2402.member_2 + _e2385), _e2389);
let _e2416 = (((_e2398 * _e2398) + (_e2399 * _e2399)) + (_e2400 * _e2400));
let _e2419 = sqrt(select(0f, _e2416, (_e2416 > 0f)));
let _e2420 = (1f / _e2419);
let _e2421 = (_e2398 * _e2420);
let _e2422 = (_e2399 * _e2420);
let _e2423 = (_e2400 * _e2420);
let _e2424 = (_e575 - _e2409);
let _e2425 = (_e587 - _e2410);
let _e2426 = (_e600 - _e2411);
let _e2431 = (((_e2424 * _e2421) + (_e2425 * _e2422)) + (_e2426 * _e2423));
let _e2436 = (((_e2424 * _e613) + (_e2425 * _e626)) + (_e2426 * _e639));
let _e2441 = (((_e2421 * _e613) + (_e2422 * _e626)) + (_e2423 * _e639));
let _e2444 = ((_e2422 * _e639) - (_e2423 * _e626));
let _e2447 = ((_e2423 * _e613) - (_e2421 * _e639));
let _e2450 = ((_e2421 * _e626) - (_e2422 * _e613));
let _e2455 = (((_e2444 * _e2444) + (_e2447 * _e2447)) + (_e2450 * _e2450));
let _e2458 = (1f / select(1e-9f, _e2455, (_e2455 > 1e-9f)));
let _e2461 = ((_e2431 - (_e2441 * _e2436)) * _e2458);
let _e2464 = (((_e2441 * _e2431) - _e2436) * _e2458);
let _e2470 = -(_e2441);
let _e2473 = global_1.member.member_13.member_2;
let _e2474 = (_e2473 * _e2473);
let _e2478 = ((1f + _e2474) - ((2f * _e2473) * _e2470));
let _e2480 = select(1e-9f, _e2478, (_e2478 > 1e-9f));
let _e2492 = global_1.member.member_13.member_3;
if (_e2492 == 2u) {
let _e2497 = (0.5f - (0.5f * _e2470));
let _e2499 = select(0f, _e2497, (_e2497 > 0f));
let _e2503 = (sqrt(select(0f, _e2499, (_e2499 > 0f))) * 255f);
let _e2504 = (255f - 1f);
let _e2506 = select(0f, _e2503, (_e2503 > 0f));
let _e2508 = select(_e2504, _e2506, (_e2506 < _e2504));
let _e2515 = select(0i, select(select(i32(_e2508), i32(-2147483648), (_e2508 < -2147483600f)), 2147483647i, (_e2508 > 2147483500f)), (_e2508 == _e2508));
let _e2519 = (_e2515 - select(0i, 1i, (_e2508 < f32(_e2515))));
let _e2522 = global_1.member.member_13.member_11;
let _e2523 = bitcast<i32>(_e2522);
let _e2524 = (_e2523 + _e2519);
let _e2526 = (bitcast<i32>(_e265) - 1i);
let _e2528 = select(_e2526, _e2524, (_e2524 < _e2526));
let _e2533 = global_2.member[bitcast<u32>(select(0i, _e2528, (_e2528 > 0i)))];
let _e2535 = (_e2523 + (_e2519 + 1i));
let _e2537 = select(_e2526, _e2535, (_e2535 < _e2526));
let _e2542 = global_2.member[bitcast<u32>(select(0i, _e2537, (_e2537 > 0i)))];
phi_4764_ = (_e2533 + ((_e2542 - _e2533) * (_e2503 - f32(_e2519))));
} else {
phi_4764_ = select(((1f - _e2474) / (_e2480 * sqrt(select(0f, _e2480, (_e2480 > 0f))))), (0.75f * (1f + (_e2470 * _e2470))), (_e2492 == 1u));
}
let _e2549 = phi_4764_;
let _e2555 = global_1.member.member_12.member_12;
let _e2558 = global_1.member.member_12.member_4;
let _e2561 = global_1.member.member_12.member_13;
let _e2567 = global_1.member.member.member;
let _e2569 = (_e2464 / _e691);
local_201 = bitcast<i32>((_e2555 + (_e2558 * _e2561)));
local_202 = _e281;
local_203 = bitcast<i32>(_e2567);
let _e2572 = global_1.member.member_13.member_6;
let _e2573 = f32(_e2572);
let _e2575 = select(0f, _e2569, (_e2569 > 0f));
let _e2578 = (select(1f, _e2575, (_e2575 < 1f)) * _e2573);
let _e2579 = (_e2573 - 1f);
let _e2581 = select(0f, _e2579, (_e2579 > 0f));
let _e2583 = select(0f, _e2578, (_e2578 > 0f));
let _e2585 = select(_e2581, _e2583, (_e2583 < _e2581));
let _e2592 = select(0i, select(select(i32(_e2585), i32(-2147483648), (_e2585 < -2147483600f)), 2147483647i, (_e2585 > 2147483500f)), (_e2585 == _e2585));
let _e2596 = (_e2592 - select(0i, 1i, (_e2585 < f32(_e2592))));
if (_e2596 > 0i) {
let _e2599 = local_201;
let _e2600 = local_203;
let _e2603 = local_202;
let _e2604 = ((_e2599 + ((_e2596 - 1i) * _e2600)) + _e2603);
let _e2606 = (bitcast<i32>(_e268) - 1i);
let _e2608 = select(_e2606, _e2604, (_e2604 < _e2606));
let _e2613 = global_7.member[bitcast<u32>(select(0i, _e2608, (_e2608 > 0i)))];
phi_4870_ = _e2613;
} else {
phi_4870_ = 0f;
}
let _e2615 = phi_4870_;
let _e2616 = local_201;
let _e2617 = local_203;
let _e2620 = local_202;
let _e2621 = ((_e2616 + (_e2596 * _e2617)) + _e2620);
let _e2623 = (bitcast<i32>(_e268) - 1i);
let _e2625 = select(_e2623, _e2621, (_e2621 < _e2623));
let _e2630 = global_7.member[bitcast<u32>(select(0i, _e2625, (_e2625 > 0i)))];
let _e2637 = (_e2337 - _e2326);
let _e2640 = ((_e2461 - _e2326) / select(1e-9f, _e2637, (_e2637 > 1e-9f)));
local_198 = 0i;
local_199 = _e2346;
local_200 = _e2312;
let _e2642 = select(0f, _e2640, (_e2640 > 0f));
let _e2645 = (select(1f, _e2642, (_e2642 < 1f)) * _e2573);
let _e2647 = select(0f, _e2645, (_e2645 > 0f));
let _e2649 = select(_e2581, _e2647, (_e2647 < _e2581));
let _e2656 = select(0i, select(select(i32(_e2649), i32(-2147483648), (_e2649 < -2147483600f)), 2147483647i, (_e2649 > 2147483500f)), (_e2649 == _e2649));
let _e2660 = (_e2656 - select(0i, 1i, (_e2649 < f32(_e2656))));
if (_e2660 > 0i) {
let _e2663 = local_198;
let _e2664 = local_200;
let _e2667 = local_199;
let _e2668 = ((_e2663 + ((_e2660 - 1i) * _e2664)) + _e2667);
let _e2670 = select(_e2623, _e2668, (_e2668 < _e2623));
let _e2675 = global_7.member[bitcast<u32>(select(0i, _e2670, (_e2670 > 0i)))];
phi_4997_ = _e2675;
} else {
phi_4997_ = 0f;
}
let _e2677 = phi_4997_;
let _e2678 = local_198;
let _e2679 = local_200;
let _e2682 = local_199;
let _e2683 = ((_e2678 + (_e2660 * _e2679)) + _e2682);
let _e2685 = select(_e2623, _e2683, (_e2683 < _e2623));
let _e2690 = global_7.member[bitcast<u32>(select(0i, _e2685, (_e2685 > 0i)))];
let _e2696 = ((_e2615 + ((_e2630 - _e2615) * (_e2578 - f32(_e2596)))) + (_e2677 + ((_e2690 - _e2677) * (_e2645 - f32(_e2660)))));
let _e2705 = global_1.member.member_13.member_7;
let _e2706 = bitcast<i32>(_e2705);
let _e2709 = global_1.member.member_13.member_8;
let _e2710 = bitcast<i32>(_e2709);
let _e2713 = global_1.member.member_13.member_9;
let _e2714 = bitcast<i32>(_e2713);
let _e2717 = global_1.member.member_13.member_4;
let _e2723 = global_1.member.member_13.member_5;
let _e2727 = f32(_e2706);
let _e2732 = (((((_e2409 + (_e2421 * _e2461)) - _e2717.member) / (_e2723.member - _e2717.member)) * _e2727) - 0.5f);
let _e2733 = (_e2727 - 1f);
let _e2735 = select(0f, _e2732, (_e2732 > 0f));
let _e2737 = select(_e2733, _e2735, (_e2735 < _e2733));
let _e2738 = f32(_e2710);
let _e2743 = (((((_e2410 + (_e2422 * _e2461)) - _e2717.member_1) / (_e2723.member_1 - _e2717.member_1)) * _e2738) - 0.5f);
let _e2744 = (_e2738 - 1f);
let _e2746 = select(0f, _e2743, (_e2743 > 0f));
let _e2748 = select(_e2744, _e2746, (_e2746 < _e2744));
let _e2749 = f32(_e2714);
let _e2754 = (((((_e2411 + (_e2423 * _e2461)) - _e2717.member_2) / (_e2723.member_2 - _e2717.member_2)) * _e2749) - 0.5f);
let _e2755 = (_e2749 - 1f);
let _e2757 = select(0f, _e2754, (_e2754 > 0f));
let _e2759 = select(_e2755, _e2757, (_e2757 < _e2755));
let _e2761 = select(0f, _e2737, (_e2737 > 0f));
let _e2763 = select(1e6f, _e2761, (_e2761 < 1e6f));
let _e2770 = select(0i, select(select(i32(_e2763), i32(-2147483648), (_e2763 < -2147483600f)), 2147483647i, (_e2763 > 2147483500f)), (_e2763 == _e2763));
let _e2774 = (_e2770 - select(0i, 1i, (_e2763 < f32(_e2770))));
let _e2776 = select(0f, _e2748, (_e2748 > 0f));
let _e2778 = select(1e6f, _e2776, (_e2776 < 1e6f));
let _e2785 = select(0i, select(select(i32(_e2778), i32(-2147483648), (_e2778 < -2147483600f)), 2147483647i, (_e2778 > 2147483500f)), (_e2778 == _e2778));
let _e2789 = (_e2785 - select(0i, 1i, (_e2778 < f32(_e2785))));
let _e2791 = select(0f, _e2759, (_e2759 > 0f));
let _e2793 = select(1e6f, _e2791, (_e2791 < 1e6f));
let _e2800 = select(0i, select(select(i32(_e2793), i32(-2147483648), (_e2793 < -2147483600f)), 2147483647i, (_e2793 > 2147483500f)), (_e2793 == _e2793));
let _e2804 = (_e2800 - select(0i, 1i, (_e2793 < f32(_e2800))));
let _e2808 = (_e2748 - f32(_e2789));
let _e2810 = (_e2759 - f32(_e2804));
local_196 = (_e2737 - f32(_e2774));
let _e2811 = (_e2774 + 1i);
let _e2813 = select(_e2811, 0i, (_e2811 < 0i));
if (_e2813 >= _e2706) {
phi_5145_ = (_e2706 - 1i);
} else {
phi_5145_ = _e2813;
}
let _e2817 = phi_5145_;
local_197 = (_e2817 - _e2774);
let _e2819 = (_e2789 + 1i);
let _e2821 = select(_e2819, 0i, (_e2819 < 0i));
if (_e2821 >= _e2710) {
phi_5158_ = (_e2710 - 1i);
} else {
phi_5158_ = _e2821;
}
let _e2825 = phi_5158_;
let _e2827 = ((_e2825 - _e2789) * _e2706);
let _e2828 = (_e2804 + 1i);
let _e2830 = select(_e2828, 0i, (_e2828 < 0i));
if (_e2830 >= _e2714) {
phi_5172_ = (_e2714 - 1i);
} else {
phi_5172_ = _e2830;
}
let _e2834 = phi_5172_;
let _e2840 = global_1.member.member_13.member_10;
let _e2846 = ((bitcast<i32>(_e2840) + (((_e2804 * _e2710) + _e2789) * _e2706)) + _e2774);
let _e2848 = (bitcast<i32>(_e265) - 1i);
let _e2850 = select(_e2848, _e2846, (_e2846 < _e2848));
let _e2855 = global_2.member[bitcast<u32>(select(0i, _e2850, (_e2850 > 0i)))];
let _e2856 = local_196;
let _e2859 = local_197;
let _e2860 = (_e2846 + _e2859);
let _e2862 = select(_e2848, _e2860, (_e2860 < _e2848));
let _e2867 = global_2.member[bitcast<u32>(select(0i, _e2862, (_e2862 > 0i)))];
let _e2868 = local_196;
let _e2871 = (1f - _e2808);
let _e2873 = (_e2846 + _e2827);
let _e2875 = select(_e2848, _e2873, (_e2873 < _e2848));
let _e2880 = global_2.member[bitcast<u32>(select(0i, _e2875, (_e2875 > 0i)))];
let _e2881 = local_196;
let _e2884 = local_197;
let _e2885 = (_e2873 + _e2884);
let _e2887 = select(_e2848, _e2885, (_e2885 < _e2848));
let _e2892 = global_2.member[bitcast<u32>(select(0i, _e2887, (_e2887 > 0i)))];
let _e2893 = local_196;
let _e2898 = (_e2846 + (((_e2834 - _e2804) * _e2706) * _e2710));
let _e2900 = select(_e2848, _e2898, (_e2898 < _e2848));
let _e2905 = global_2.member[bitcast<u32>(select(0i, _e2900, (_e2900 > 0i)))];
let _e2906 = local_196;
let _e2909 = local_197;
let _e2910 = (_e2898 + _e2909);
let _e2912 = select(_e2848, _e2910, (_e2910 < _e2848));
let _e2917 = global_2.member[bitcast<u32>(select(0i, _e2912, (_e2912 > 0i)))];
let _e2918 = local_196;
let _e2922 = (_e2898 + _e2827);
let _e2924 = select(_e2848, _e2922, (_e2922 < _e2848));
let _e2929 = global_2.member[bitcast<u32>(select(0i, _e2924, (_e2924 > 0i)))];
let _e2930 = local_196;
let _e2933 = local_197;
let _e2934 = (_e2922 + _e2933);
let _e2936 = select(_e2848, _e2934, (_e2934 < _e2848));
let _e2941 = global_2.member[bitcast<u32>(select(0i, _e2936, (_e2936 > 0i)))];
let _e2942 = local_196;
let _e2951 = ((_e2419 * (_e2549 * (0.25f / 3.1415927f))) * ((((((_e2855 * (1f - _e2856)) + (_e2867 * _e2868)) * _e2871) + (((_e2880 * (1f - _e2881)) + (_e2892 * _e2893)) * _e2808)) * (1f - _e2810)) + (((((_e2905 * (1f - _e2906)) + (_e2917 * _e2918)) * _e2871) + (((_e2929 * (1f - _e2930)) + (_e2941 * _e2942)) * _e2808)) * _e2810)));
let _e2954 = global_1.member.member_13.member_1;
let _e2963 = global_1.member.member_13.member;
let _e2968 = -((_e2963.member * _e2696));
let _e2970 = select(-87f, _e2968, (_e2968 > -87f));
let _e2972 = select(88f, _e2970, (_e2970 < 88f));
let _e2974 = ((_e2972 * 1.442695f) + 0.5f);
let _e2976 = select(-127f, _e2974, (_e2974 > -127f));
let _e2978 = select(128f, _e2976, (_e2976 < 128f));
let _e2985 = select(0i, select(select(i32(_e2978), i32(-2147483648), (_e2978 < -2147483600f)), 2147483647i, (_e2978 > 2147483500f)), (_e2978 == _e2978));
let _e2989 = (_e2985 - select(0i, 1i, (_e2978 < f32(_e2985))));
let _e2990 = f32(_e2989);
let _e2994 = ((_e2972 - (_e2990 * 0.6933594f)) - (_e2990 * -2.1219444e-4f));
let _e3016 = -((_e2963.member_1 * _e2696));
let _e3018 = select(-87f, _e3016, (_e3016 > -87f));
let _e3020 = select(88f, _e3018, (_e3018 < 88f));
let _e3022 = ((_e3020 * 1.442695f) + 0.5f);
let _e3024 = select(-127f, _e3022, (_e3022 > -127f));
let _e3026 = select(128f, _e3024, (_e3024 < 128f));
let _e3033 = select(0i, select(select(i32(_e3026), i32(-2147483648), (_e3026 < -2147483600f)), 2147483647i, (_e3026 > 2147483500f)), (_e3026 == _e3026));
let _e3037 = (_e3033 - select(0i, 1i, (_e3026 < f32(_e3033))));
let _e3038 = f32(_e3037);
let _e3042 = ((_e3020 - (_e3038 * 0.6933594f)) - (_e3038 * -2.1219444e-4f));
let _e3064 = -((_e2963.member_2 * _e2696));
let _e3066 = select(-87f, _e3064, (_e3064 > -87f));
let _e3068 = select(88f, _e3066, (_e3066 < 88f));
let _e3070 = ((_e3068 * 1.442695f) + 0.5f);
let _e3072 = select(-127f, _e3070, (_e3070 > -127f));
let _e3074 = select(128f, _e3072, (_e3072 < 128f));
let _e3081 = select(0i, select(select(i32(_e3074), i32(-2147483648), (_e3074 < -2147483600f)), 2147483647i, (_e3074 > 2147483500f)), (_e3074 == _e3074));
let _e3085 = (_e3081 - select(0i, 1i, (_e3074 < f32(_e3081))));
let _e3086 = f32(_e3085);
let _e3090 = ((_e3068 - (_e3086 * 0.6933594f)) - (_e3086 * -2.1219444e-4f));
let _e3117 = select(0f, _e2461, (((_e2464 >= 0f) && (_e2464 < _e691)) && (_e2461 > 0f)));
let _e3119 = ((_e766 + _e984) + _e988);
let _e3120 = (_e3119 & 31u);
let _e3122 = (1u << bitcast<u32>(_e3120));
let _e3131 = bitcast<i32>((((_e927 + _e3122) - 1u) >> bitcast<u32>(_e3120)));
let _e3132 = bitcast<i32>((((_e930 + _e3122) - 1u) >> bitcast<u32>(_e3120)));
if _e453 {
phi_5633_ = type_23(_e3132, _e3131);
} else {
phi_5633_ = type_23(_e3131, _e3132);
}
let _e3136 = phi_5633_;
let _e3141 = f32((1i << bitcast<u32>(_e3120)));
let _e3142 = (1f / _e3141);
let _e3144 = ((_e2164 * _e3142) - 0.5f);
let _e3146 = ((_e2257 * _e3142) - 0.5f);
let _e3148 = select(-1f, _e3144, (_e3144 > -1f));
let _e3150 = select(1e6f, _e3148, (_e3148 < 1e6f));
let _e3157 = select(0i, select(select(i32(_e3150), i32(-2147483648), (_e3150 < -2147483600f)), 2147483647i, (_e3150 > 2147483500f)), (_e3150 == _e3150));
let _e3161 = (_e3157 - select(0i, 1i, (_e3150 < f32(_e3157))));
let _e3163 = select(-1f, _e3146, (_e3146 > -1f));
let _e3165 = select(1e6f, _e3163, (_e3163 < 1e6f));
let _e3172 = select(0i, select(select(i32(_e3165), i32(-2147483648), (_e3165 < -2147483600f)), 2147483647i, (_e3165 > 2147483500f)), (_e3165 == _e3165));
let _e3176 = (_e3172 - select(0i, 1i, (_e3165 < f32(_e3172))));
let _e3178 = (_e3144 - f32(_e3161));
let _e3180 = (_e3146 - f32(_e3176));
let _e3181 = (1f - _e3178);
let _e3182 = (1f - _e3180);
let _e3185 = select(_e3161, 0i, (_e3161 < 0i));
let _e3186 = (_e3185 >= _e3136.member);
if _e3186 {
phi_5711_ = (_e3136.member - 1i);
} else {
phi_5711_ = _e3185;
}
let _e3189 = phi_5711_;
let _e3191 = select(_e3176, 0i, (_e3176 < 0i));
let _e3192 = (_e3191 >= _e3136.member_1);
if _e3192 {
phi_5722_ = (_e3136.member_1 - 1i);
} else {
phi_5722_ = _e3191;
}
let _e3195 = phi_5722_;
let _e3199 = (((f32(_e3189) + 0.5f) * _e3141) - 0.5f);
let _e3203 = (((f32(_e3195) + 0.5f) * _e3141) - 0.5f);
if _e453 {
phi_5750_ = type_23(_e3195, _e3189);
} else {
phi_5750_ = type_23(_e3189, _e3195);
}
let _e3209 = phi_5750_;
let _e3215 = bitcast<i32>(((_e927 + 1u) >> bitcast<u32>(1u)));
let _e3218 = global_1.member.member_18.member_6;
let _e3221 = global_1.member.member_18.member_7;
let _e3224 = global_1.member.member_18.member_8;
let _e3225 = (_e3119 == 0u);
if _e3225 {
phi_5801_ = 0u;
} else {
if (_e3119 == 1u) {
phi_5800_ = 0u;
} else {
if (_e3119 == 2u) {
phi_5799_ = _e3218;
} else {
phi_5799_ = select(_e3224, _e3221, (_e3119 == 3u));
}
let _e3231 = phi_5799_;
phi_5800_ = _e3231;
}
let _e3233 = phi_5800_;
phi_5801_ = _e3233;
}
let _e3235 = phi_5801_;
local_194 = (((bitcast<i32>(_e3235) + _e3209.member_1) * _e3215) + _e3209.member);
let _e3240 = local_194;
let _e3242 = (bitcast<i32>(_e262) - 1i);
let _e3244 = select(_e3242, _e3240, (_e3240 < _e3242));
let _e3249 = global_6.member[bitcast<u32>(select(0i, _e3244, (_e3244 > 0i)))];
let _e3254 = (((((select(_e3199, _e3203, _e453) + 0.5f) / _e2349) * 2f) - 1f) * _e2357);
let _e3259 = ((1f - (((select(_e3203, _e3199, _e453) + 0.5f) / _e2350) * 2f)) * _e2365);
let _e3266 = ((_e2368.member * _e3254) + (_e2376.member * _e3259));
let _e3267 = ((_e2368.member_1 * _e3254) + (_e2376.member_1 * _e3259));
let _e3268 = ((_e2368.member_2 * _e3254) + (_e2376.member_2 * _e3259));
let _e3272 = select((_e2391.member + _e3266), _e2391.member, _e2389);
let _e3273 = select((_e2391.member_1 + _e3267), _e2391.member_1, _e2389);
let _e3274 = select((_e2391.member_2 + _e3268), _e2391.member_2, _e2389);
let _e3285 = (((_e3272 * _e3272) + (_e3273 * _e3273)) + (_e3274 * _e3274));
let _e3289 = (1f / sqrt(select(0f, _e3285, (_e3285 > 0f))));
let _e3290 = (_e3272 * _e3289);
let _e3291 = (_e3273 * _e3289);
let _e3292 = (_e3274 * _e3289);
let _e3293 = (_e575 - select(_e2402.member, (_e2402.member + _e3266), _e2389));
let _e3294 = (_e587 - select(_e2402.member_1, (_e2402.member_1 + _e3267), _e2389));
let _e3295 = (_e600 - select(_e2402.member_2, (_e2402.member_2 + _e3268), _e2389));
let _e3300 = (((_e3293 * _e3290) + (_e3294 * _e3291)) + (_e3295 * _e3292));
let _e3305 = (((_e3293 * _e613) + (_e3294 * _e626)) + (_e3295 * _e639));
let _e3310 = (((_e3290 * _e613) + (_e3291 * _e626)) + (_e3292 * _e639));
let _e3313 = ((_e3291 * _e639) - (_e3292 * _e626));
let _e3316 = ((_e3292 * _e613) - (_e3290 * _e639));
let _e3319 = ((_e3290 * _e626) - (_e3291 * _e613));
let _e3324 = (((_e3313 * _e3313) + (_e3316 * _e3316)) + (_e3319 * _e3319));
let _e3327 = (1f / select(1e-9f, _e3324, (_e3324 > 1e-9f)));
let _e3330 = ((_e3300 - (_e3310 * _e3305)) * _e3327);
let _e3333 = (((_e3310 * _e3300) - _e3305) * _e3327);
let _e3339 = select(0f, _e3330, (((_e3333 >= 0f) && (_e3333 < _e691)) && (_e3330 > 0f)));
let _e3341 = (_e3189 << bitcast<u32>(_e3120));
let _e3353 = (_e3161 + 1i);
let _e3356 = select(_e3353, 0i, (_e3353 < 0i));
let _e3357 = (_e3356 >= _e3136.member);
if _e3357 {
phi_6462_ = (_e3136.member - 1i);
} else {
phi_6462_ = _e3356;
}
let _e3360 = phi_6462_;
if _e3192 {
phi_6473_ = (_e3136.member_1 - 1i);
} else {
phi_6473_ = _e3191;
}
let _e3363 = phi_6473_;
let _e3367 = (((f32(_e3360) + 0.5f) * _e3141) - 0.5f);
let _e3371 = (((f32(_e3363) + 0.5f) * _e3141) - 0.5f);
if _e453 {
phi_6501_ = type_23(_e3363, _e3360);
} else {
phi_6501_ = type_23(_e3360, _e3363);
}
let _e3377 = phi_6501_;
if _e3225 {
phi_6552_ = 0u;
} else {
if (_e3119 == 1u) {
phi_6551_ = 0u;
} else {
if (_e3119 == 2u) {
phi_6550_ = _e3218;
} else {
phi_6550_ = select(_e3224, _e3221, (_e3119 == 3u));
}
let _e3385 = phi_6550_;
phi_6551_ = _e3385;
}
let _e3387 = phi_6551_;
phi_6552_ = _e3387;
}
let _e3389 = phi_6552_;
local_192 = (((bitcast<i32>(_e3389) + _e3377.member_1) * _e3215) + _e3377.member);
let _e3394 = local_192;
let _e3396 = select(_e3242, _e3394, (_e3394 < _e3242));
let _e3401 = global_6.member[bitcast<u32>(select(0i, _e3396, (_e3396 > 0i)))];
let _e3406 = (((((select(_e3367, _e3371, _e453) + 0.5f) / _e2349) * 2f) - 1f) * _e2357);
let _e3411 = ((1f - (((select(_e3371, _e3367, _e453) + 0.5f) / _e2350) * 2f)) * _e2365);
let _e3418 = ((_e2368.member * _e3406) + (_e2376.member * _e3411));
let _e3419 = ((_e2368.member_1 * _e3406) + (_e2376.member_1 * _e3411));
let _e3420 = ((_e2368.member_2 * _e3406) + (_e2376.member_2 * _e3411));
let _e3424 = select((_e2391.member + _e3418), _e2391.member, _e2389);
let _e3425 = select((_e2391.member_1 + _e3419), _e2391.member_1, _e2389);
let _e3426 = select((_e2391.member_2 + _e3420), _e2391.member_2, _e2389);
let _e3437 = (((_e3424 * _e3424) + (_e3425 * _e3425)) + (_e3426 * _e3426));
let _e3441 = (1f / sqrt(select(0f, _e3437, (_e3437 > 0f))));
let _e3442 = (_e3424 * _e3441);
let _e3443 = (_e3425 * _e3441);
let _e3444 = (_e3426 * _e3441);
let _e3445 = (_e575 - select(_e2402.member, (_e2402.member + _e3418), _e2389));
let _e3446 = (_e587 - select(_e2402.member_1, (_e2402.member_1 + _e3419), _e2389));
let _e3447 = (_e600 - select(_e2402.member_2, (_e2402.member_2 + _e3420), _e2389));
let _e3452 = (((_e3445 * _e3442) + (_e3446 * _e3443)) + (_e3447 * _e3444));
let _e3457 = (((_e3445 * _e613) + (_e3446 * _e626)) + (_e3447 * _e639));
let _e3462 = (((_e3442 * _e613) + (_e3443 * _e626)) + (_e3444 * _e639));
let _e3465 = ((_e3443 * _e639) - (_e3444 * _e626));
let _e3468 = ((_e3444 * _e613) - (_e3442 * _e639));
let _e3471 = ((_e3442 * _e626) - (_e3443 * _e613));
let _e3476 = (((_e3465 * _e3465) + (_e3468 * _e3468)) + (_e3471 * _e3471));
let _e3479 = (1f / select(1e-9f, _e3476, (_e3476 > 1e-9f)));
let _e3482 = ((_e3452 - (_e3462 * _e3457)) * _e3479);
let _e3485 = (((_e3462 * _e3452) - _e3457) * _e3479);
let _e3491 = select(0f, _e3482, (((_e3485 >= 0f) && (_e3485 < _e691)) && (_e3482 > 0f)));
let _e3493 = (_e3360 << bitcast<u32>(_e3120));
let _e3505 = (_e3176 + 1i);
if _e3186 {
phi_7213_ = (_e3136.member - 1i);
} else {
phi_7213_ = _e3185;
}
let _e3509 = phi_7213_;
let _e3511 = select(_e3505, 0i, (_e3505 < 0i));
let _e3512 = (_e3511 >= _e3136.member_1);
if _e3512 {
phi_7224_ = (_e3136.member_1 - 1i);
} else {
phi_7224_ = _e3511;
}
let _e3515 = phi_7224_;
let _e3519 = (((f32(_e3509) + 0.5f) * _e3141) - 0.5f);
let _e3523 = (((f32(_e3515) + 0.5f) * _e3141) - 0.5f);
if _e453 {
phi_7252_ = type_23(_e3515, _e3509);
} else {
phi_7252_ = type_23(_e3509, _e3515);
}
let _e3529 = phi_7252_;
if _e3225 {
phi_7303_ = 0u;
} else {
if (_e3119 == 1u) {
phi_7302_ = 0u;
} else {
if (_e3119 == 2u) {
phi_7301_ = _e3218;
} else {
phi_7301_ = select(_e3224, _e3221, (_e3119 == 3u));
}
let _e3537 = phi_7301_;
phi_7302_ = _e3537;
}
let _e3539 = phi_7302_;
phi_7303_ = _e3539;
}
let _e3541 = phi_7303_;
local_190 = (((bitcast<i32>(_e3541) + _e3529.member_1) * _e3215) + _e3529.member);
let _e3546 = local_190;
let _e3548 = select(_e3242, _e3546, (_e3546 < _e3242));
let _e3553 = global_6.member[bitcast<u32>(select(0i, _e3548, (_e3548 > 0i)))];
let _e3558 = (((((select(_e3519, _e3523, _e453) + 0.5f) / _e2349) * 2f) - 1f) * _e2357);
let _e3563 = ((1f - (((select(_e3523, _e3519, _e453) + 0.5f) / _e2350) * 2f)) * _e2365);
let _e3570 = ((_e2368.member * _e3558) + (_e2376.member * _e3563));
let _e3571 = ((_e2368.member_1 * _e3558) + (_e2376.member_1 * _e3563));
let _e3572 = ((_e2368.member_2 * _e3558) + (_e2376.member_2 * _e3563));
let _e3576 = select((_e2391.member + _e3570), _e2391.member, _e2389);
let _e3577 = select((_e2391.member_1 + _e3571), _e2391.member_1, _e2389);
let _e3578 = select((_e2391.member_2 + _e3572), _e2391.member_2, _e2389);
let _e3589 = (((_e3576 * _e3576) + (_e3577 * _e3577)) + (_e3578 * _e3578));
let _e3593 = (1f / sqrt(select(0f, _e3589, (_e3589 > 0f))));
let _e3594 = (_e3576 * _e3593);
let _e3595 = (_e3577 * _e3593);
let _e3596 = (_e3578 * _e3593);
let _e3597 = (_e575 - select(_e2402.member, (_e2402.member + _e3570), _e2389));
let _e3598 = (_e587 - select(_e2402.member_1, (_e2402.member_1 + _e3571), _e2389));
let _e3599 = (_e600 - select(_e2402.member_2, (_e2402.member_2 + _e3572), _e2389));
let _e3604 = (((_e3597 * _e3594) + (_e3598 * _e3595)) + (_e3599 * _e3596));
let _e3609 = (((_e3597 * _e613) + (_e3598 * _e626)) + (_e3599 * _e639));
let _e3614 = (((_e3594 * _e613) + (_e3595 * _e626)) + (_e3596 * _e639));
let _e3617 = ((_e3595 * _e639) - (_e3596 * _e626));
let _e3620 = ((_e3596 * _e613) - (_e3594 * _e639));
let _e3623 = ((_e3594 * _e626) - (_e3595 * _e613));
let _e3628 = (((_e3617 * _e3617) + (_e3620 * _e3620)) + (_e3623 * _e3623));
let _e3631 = (1f / select(1e-9f, _e3628, (_e3628 > 1e-9f)));
let _e3634 = ((_e3604 - (_e3614 * _e3609)) * _e3631);
let _e3637 = (((_e3614 * _e3604) - _e3609) * _e3631);
let _e3643 = select(0f, _e3634, (((_e3637 >= 0f) && (_e3637 < _e691)) && (_e3634 > 0f)));
let _e3645 = (_e3509 << bitcast<u32>(_e3120));
if _e3357 {
phi_7964_ = (_e3136.member - 1i);
} else {
phi_7964_ = _e3356;
}
let _e3660 = phi_7964_;
if _e3512 {
phi_7975_ = (_e3136.member_1 - 1i);
} else {
phi_7975_ = _e3511;
}
let _e3663 = phi_7975_;
let _e3667 = (((f32(_e3660) + 0.5f) * _e3141) - 0.5f);
let _e3671 = (((f32(_e3663) + 0.5f) * _e3141) - 0.5f);
if _e453 {
phi_8003_ = type_23(_e3663, _e3660);
} else {
phi_8003_ = type_23(_e3660, _e3663);
}
let _e3677 = phi_8003_;
if _e3225 {
phi_8054_ = 0u;
} else {
if (_e3119 == 1u) {
phi_8053_ = 0u;
} else {
if (_e3119 == 2u) {
phi_8052_ = _e3218;
} else {
phi_8052_ = select(_e3224, _e3221, (_e3119 == 3u));
}
let _e3685 = phi_8052_;
phi_8053_ = _e3685;
}
let _e3687 = phi_8053_;
phi_8054_ = _e3687;
}
let _e3689 = phi_8054_;
local_188 = (((bitcast<i32>(_e3689) + _e3677.member_1) * _e3215) + _e3677.member);
let _e3694 = local_188;
let _e3696 = select(_e3242, _e3694, (_e3694 < _e3242));
let _e3701 = global_6.member[bitcast<u32>(select(0i, _e3696, (_e3696 > 0i)))];
let _e3706 = (((((select(_e3667, _e3671, _e453) + 0.5f) / _e2349) * 2f) - 1f) * _e2357);
let _e3711 = ((1f - (((select(_e3671, _e3667, _e453) + 0.5f) / _e2350) * 2f)) * _e2365);
let _e3718 = ((_e2368.member * _e3706) + (_e2376.member * _e3711));
let _e3719 = ((_e2368.member_1 * _e3706) + (_e2376.member_1 * _e3711));
let _e3720 = ((_e2368.member_2 * _e3706) + (_e2376.member_2 * _e3711));
let _e3724 = select((_e2391.member + _e3718), _e2391.member, _e2389);
let _e3725 = select((_e2391.member_1 + _e3719), _e2391.member_1, _e2389);
let _e3726 = select((_e2391.member_2 + _e3720), _e2391.member_2, _e2389);
let _e3737 = (((_e3724 * _e3724) + (_e3725 * _e3725)) + (_e3726 * _e3726));
let _e3741 = (1f / sqrt(select(0f, _e3737, (_e3737 > 0f))));
let _e3742 = (_e3724 * _e3741);
let _e3743 = (_e3725 * _e3741);
let _e3744 = (_e3726 * _e3741);
let _e3745 = (_e575 - select(_e2402.member, (_e2402.member + _e3718), _e2389));
let _e3746 = (_e587 - select(_e2402.member_1, (_e2402.member_1 + _e3719), _e2389));
let _e3747 = (_e600 - select(_e2402.member_2, (_e2402.member_2 + _e3720), _e2389));
let _e3752 = (((_e3745 * _e3742) + (_e3746 * _e3743)) + (_e3747 * _e3744));
let _e3757 = (((_e3745 * _e613) + (_e3746 * _e626)) + (_e3747 * _e639));
let _e3762 = (((_e3742 * _e613) + (_e3743 * _e626)) + (_e3744 * _e639));
let _e3765 = ((_e3743 * _e639) - (_e3744 * _e626));
let _e3768 = ((_e3744 * _e613) - (_e3742 * _e639));
let _e3771 = ((_e3742 * _e626) - (_e3743 * _e613));
let _e3776 = (((_e3765 * _e3765) + (_e3768 * _e3768)) + (_e3771 * _e3771));
let _e3779 = (1f / select(1e-9f, _e3776, (_e3776 > 1e-9f)));
let _e3782 = ((_e3752 - (_e3762 * _e3757)) * _e3779);
let _e3785 = (((_e3762 * _e3752) - _e3757) * _e3779);
let _e3791 = select(0f, _e3782, (((_e3785 >= 0f) && (_e3785 < _e691)) && (_e3782 > 0f)));
let _e3793 = (_e3660 << bitcast<u32>(_e3120));
let _e3805 = select(((((1f - select(0f, (_e3181 * _e3182), (((select(select(_e766, _e923, (_e3341 >= _e692)), _e845, (_e3341 < _e298)) == _e3119) && (_e3339 > 0f)) && (_e3339 < _e3249)))) - select(0f, (_e3178 * _e3182), (((select(select(_e766, _e923, (_e3493 >= _e692)), _e845, (_e3493 < _e298)) == _e3119) && (_e3491 > 0f)) && (_e3491 < _e3401)))) - select(0f, (_e3181 * _e3180), (((select(select(_e766, _e923, (_e3645 >= _e692)), _e845, (_e3645 < _e298)) == _e3119) && (_e3643 > 0f)) && (_e3643 < _e3553)))) - select(0f, (_e3178 * _e3180), (((select(select(_e766, _e923, (_e3793 >= _e692)), _e845, (_e3793 < _e298)) == _e3119) && (_e3791 > 0f)) && (_e3791 < _e3701)))), 1f, _e3225);
if _e453 {
phi_8724_ = type_23(_e2254, _e2162);
} else {
phi_8724_ = type_23(_e2162, _e2254);
}
let _e3820 = phi_8724_;
let _e3823 = (_e2255 && (((_e3117 > 0f) && (_e3117 < _e2345)) && (bitcast<f32>((bitcast<u32>(_e3805) & 2147483647u)) > 1e-6f)));
let _e3826 = global_1.member.member_18.member;
let _e3827 = (((select(_e2280, (1f - _e2280), (_e2265 >= 0f)) - select(_e2299, (1f - _e2299), (_e2284 >= 0f))) * (1f / _e2262)) * _e3826);
let _e3831 = select(0f, (((((_e652 * _e2954.member) * ((1f + (_e2994 * (1f + (_e2994 * (0.5f + (_e2994 * (0.16666667f + (_e2994 * (0.041666668f + (_e2994 * (0.008333334f + (_e2994 * (0.001388889f + (_e2994 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2989 + 127i)) << bitcast<u32>(23i))))) * _e2951) * _e3805) * _e3827), _e3823);
let _e3832 = select(0f, (((((_e665 * _e2954.member_1) * ((1f + (_e3042 * (1f + (_e3042 * (0.5f + (_e3042 * (0.16666667f + (_e3042 * (0.041666668f + (_e3042 * (0.008333334f + (_e3042 * (0.001388889f + (_e3042 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3037 + 127i)) << bitcast<u32>(23i))))) * _e2951) * _e3805) * _e3827), _e3823);
let _e3833 = select(0f, (((((_e678 * _e2954.member_2) * ((1f + (_e3090 * (1f + (_e3090 * (0.5f + (_e3090 * (0.16666667f + (_e3090 * (0.041666668f + (_e3090 * (0.008333334f + (_e3090 * (0.001388889f + (_e3090 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3085 + 127i)) << bitcast<u32>(23i))))) * _e2951) * _e3805) * _e3827), _e3823);
let _e3837 = (bitcast<f32>((bitcast<u32>(_e3831) & 2147483647u)) >= 1073741800f);
let _e3838 = (1f / 1048576f);
let _e3841 = ((_e3831 * select(1f, _e3838, _e3837)) + 0.5f);
let _e3843 = select(-1073741800f, _e3841, (_e3841 > -1073741800f));
let _e3845 = select(1073741800f, _e3843, (_e3843 < 1073741800f));
let _e3852 = select(0i, select(select(i32(_e3845), i32(-2147483648), (_e3845 < -2147483600f)), 2147483647i, (_e3845 > 2147483500f)), (_e3845 == _e3845));
let _e3856 = (_e3852 - select(0i, 1i, (_e3845 < f32(_e3852))));
let _e3857 = select(0i, 20i, _e3837);
let _e3861 = (bitcast<u32>(_e3856) << bitcast<u32>((_e3857 & 31i)));
let _e3868 = bitcast<u32>(((_e3856 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e3857) & 31i))));
let _e3872 = (bitcast<f32>((bitcast<u32>(_e3832) & 2147483647u)) >= 1073741800f);
let _e3875 = ((_e3832 * select(1f, _e3838, _e3872)) + 0.5f);
let _e3877 = select(-1073741800f, _e3875, (_e3875 > -1073741800f));
let _e3879 = select(1073741800f, _e3877, (_e3877 < 1073741800f));
let _e3886 = select(0i, select(select(i32(_e3879), i32(-2147483648), (_e3879 < -2147483600f)), 2147483647i, (_e3879 > 2147483500f)), (_e3879 == _e3879));
let _e3890 = (_e3886 - select(0i, 1i, (_e3879 < f32(_e3886))));
let _e3891 = select(0i, 20i, _e3872);
let _e3895 = (bitcast<u32>(_e3890) << bitcast<u32>((_e3891 & 31i)));
let _e3902 = bitcast<u32>(((_e3890 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e3891) & 31i))));
let _e3906 = (bitcast<f32>((bitcast<u32>(_e3833) & 2147483647u)) >= 1073741800f);
let _e3909 = ((_e3833 * select(1f, _e3838, _e3906)) + 0.5f);
let _e3911 = select(-1073741800f, _e3909, (_e3909 > -1073741800f));
let _e3913 = select(1073741800f, _e3911, (_e3911 < 1073741800f));
let _e3920 = select(0i, select(select(i32(_e3913), i32(-2147483648), (_e3913 < -2147483600f)), 2147483647i, (_e3913 > 2147483500f)), (_e3913 == _e3913));
let _e3924 = (_e3920 - select(0i, 1i, (_e3913 < f32(_e3920))));
let _e3925 = select(0i, 20i, _e3906);
let _e3929 = (bitcast<u32>(_e3924) << bitcast<u32>((_e3925 & 31i)));
let _e3936 = bitcast<u32>(((_e3924 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e3925) & 31i))));
let _e3941 = bitcast<i32>(bitcast<u32>((((_e3820.member_1 * _e931) + _e3820.member) * 6i)));
if ((_e3861 | _e3868) == 0u) {
} else {
let _e3944 = bitcast<u32>(_e3941);
if (_e3944 < _e270) {
let _e3948 = atomicAdd((&global_8.member[_e3944]), _e3861);
phi_8957_ = _e3948;
} else {
phi_8957_ = 0u;
}
let _e3950 = phi_8957_;
let _e3954 = (_e3868 + select(0u, 1u, ((_e3950 + _e3861) < _e3861)));
if (_e3954 == 0u) {
} else {
let _e3956 = (_e3944 + 1u);
if (_e3956 < _e270) {
let _e3960 = atomicAdd((&global_8.member[_e3956]), _e3954);
}
}
}
if ((_e3895 | _e3902) == 0u) {
} else {
let _e3964 = bitcast<u32>((_e3941 + 2i));
if (_e3964 < _e270) {
let _e3968 = atomicAdd((&global_8.member[_e3964]), _e3895);
phi_8987_ = _e3968;
} else {
phi_8987_ = 0u;
}
let _e3970 = phi_8987_;
let _e3974 = (_e3902 + select(0u, 1u, ((_e3970 + _e3895) < _e3895)));
if (_e3974 == 0u) {
} else {
let _e3976 = (_e3964 + 1u);
if (_e3976 < _e270) {
let _e3980 = atomicAdd((&global_8.member[_e3976]), _e3974);
}
}
}
if ((_e3929 | _e3936) == 0u) {
} else {
let _e3984 = bitcast<u32>((_e3941 + 4i));
if (_e3984 < _e270) {
let _e3988 = atomicAdd((&global_8.member[_e3984]), _e3929);
phi_9017_ = _e3988;
} else {
phi_9017_ = 0u;
}
let _e3990 = phi_9017_;
let _e3994 = (_e3936 + select(0u, 1u, ((_e3990 + _e3929) < _e3929)));
if (_e3994 == 0u) {
} else {
let _e3996 = (_e3984 + 1u);
if (_e3996 < _e270) {
let _e4000 = atomicAdd((&global_8.member[_e3996]), _e3994);
}
}
}
phi_4233_ = (_e2252 + 1i);
} else {
phi_4233_ = i32();
}
let _e4003 = phi_4233_;
continue;
continuing {
phi_4232_ = _e4003;
break if !(_e2255);
}
}
phi_4079_ = (_e2159 + 1i);
} else {
phi_4079_ = i32();
}
let _e4007 = phi_4079_;
continue;
continuing {
phi_4078_ = _e4007;
break if !(_e2160);
}
}
} else {
phi_9062_ = 0i;
loop {
let _e4010 = phi_9062_;
let _e4011 = (_e4010 < 16i);
if _e4011 {
let _e4013 = (_e976 + (_e4010 & 15i));
let _e4015 = (f32(_e4013) + 0.5f);
let _e4017 = ((_e4015 * 1f) - 0.5f);
let _e4021 = (-(((_e416 * _e4017) + _e442)) / _e429);
let _e4028 = bitcast<f32>((bitcast<u32>(((_e466 * _e4017) + ((_e479 * _e4021) + _e492))) & 2147483647u));
let _e4035 = bitcast<f32>((bitcast<u32>(((_e505 * _e4017) + ((_e518 * _e4021) + _e531))) & 2147483647u));
let _e4039 = (((0.5f * (_e4028 + _e4035)) / _e534) + _e717);
let _e4040 = (1f / 1f);
let _e4048 = ((((_e4021 + _e4039) + 0.5f) * _e4040) - 0.5f);
let _e4049 = f32(_e981);
let _e4050 = (0f - 1f);
let _e4052 = select(_e4050, _e4048, (_e4048 > _e4050));
let _e4054 = select(_e4049, _e4052, (_e4052 < _e4049));
let _e4061 = select(0i, select(select(i32(_e4054), i32(-2147483648), (_e4054 < -2147483600f)), 2147483647i, (_e4054 > 2147483500f)), (_e4054 == _e4054));
let _e4066 = (((((_e4021 - _e4039) + 0.5f) * _e4040) - 0.5f) + 1f);
let _e4067 = (_e4049 + 1f);
let _e4069 = select(0f, _e4066, (_e4066 > 0f));
let _e4071 = select(_e4067, _e4069, (_e4069 < _e4067));
let _e4078 = select(0i, select(select(i32(_e4071), i32(-2147483648), (_e4071 < -2147483600f)), 2147483647i, (_e4071 > 2147483500f)), (_e4071 == _e4071));
let _e4089 = ((1e-4f * 1f) * _e534);
let _e4091 = select(_e4035, _e4028, (_e4028 > _e4035));
let _e4093 = select(_e4089, _e4091, (_e4091 > _e4089));
let _e4095 = select(_e4035, _e4028, (_e4028 < _e4035));
let _e4097 = select(_e4089, _e4095, (_e4095 > _e4089));
let _e4099 = (0.5f * (_e4093 + _e4097));
let _e4100 = (0.5f / _e4097);
let _e4101 = (1f / _e4093);
phi_9216_ = 0i;
loop {
let _e4103 = phi_9216_;
let _e4105 = (((_e4078 - select(0i, 1i, (_e4071 < f32(_e4078)))) + (_e4010 >> bitcast<u32>(4u))) + bitcast<i32>(_e4103));
let _e4106 = (_e4105 <= select(-1i, (_e4061 - select(0i, 1i, (_e4054 < f32(_e4061)))), (_e4013 <= _e980)));
if _e4106 {
let _e4108 = (f32(_e4105) + 0.5f);
let _e4112 = ((((_e4108 * 1f) - 0.5f) - _e4021) * _e534);
let _e4113 = (_e534 * 1f);
let _e4115 = (0.5f * _e4113);
let _e4116 = (_e4112 + _e4115);
let _e4117 = -(_e4116);
let _e4120 = (_e4099 - select(_e4117, _e4116, (_e4116 > _e4117)));
let _e4122 = select(0f, _e4120, (_e4120 > 0f));
let _e4124 = select(_e4097, _e4122, (_e4122 < _e4097));
let _e4127 = (_e4120 - _e4097);
let _e4131 = (((_e4124 * (_e4124 * _e4100)) + select(0f, _e4127, (_e4127 > 0f))) * _e4101);
let _e4135 = (_e4112 - _e4115);
let _e4136 = -(_e4135);
let _e4139 = (_e4099 - select(_e4136, _e4135, (_e4135 > _e4136)));
let _e4141 = select(0f, _e4139, (_e4139 > 0f));
let _e4143 = select(_e4097, _e4141, (_e4141 < _e4097));
let _e4146 = (_e4139 - _e4097);
let _e4150 = (((_e4143 * (_e4143 * _e4100)) + select(0f, _e4146, (_e4146 > 0f))) * _e4101);
if _e453 {
phi_9321_ = type_23(_e4105, _e4013);
} else {
phi_9321_ = type_23(_e4013, _e4105);
}
let _e4159 = phi_9321_;
let _e4163 = bitcast<i32>((_e927 * _e930));
local_186 = _e4163;
local_187 = ((_e4159.member_1 * _e931) + _e4159.member);
let _e4166 = local_186;
let _e4167 = local_187;
let _e4168 = (_e4166 + _e4167);
let _e4170 = (bitcast<i32>(_e259) - 1i);
let _e4172 = select(_e4170, _e4168, (_e4168 < _e4170));
let _e4177 = global_5.member[bitcast<u32>(select(0i, _e4172, (_e4172 > 0i)))];
let _e4178 = local_186;
let _e4180 = local_187;
let _e4181 = ((2i * _e4178) + _e4180);
let _e4183 = select(_e4170, _e4181, (_e4181 < _e4170));
let _e4188 = global_5.member[bitcast<u32>(select(0i, _e4183, (_e4183 > 0i)))];
let _e4189 = local_187;
let _e4191 = select(_e4170, _e4189, (_e4189 < _e4170));
let _e4196 = global_5.member[bitcast<u32>(select(0i, _e4191, (_e4191 > 0i)))];
let _e4197 = local_187;
let _e4200 = f32(_e931);
let _e4201 = f32(_e932);
let _e4208 = global_1.member.member_2.member;
let _e4209 = (((((f32(_e4159.member) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e4216 = global_1.member.member_2.member_1;
let _e4217 = ((1f - (((f32(_e4159.member_1) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e4219 = global_1.member.member_3;
let _e4227 = global_1.member.member_4;
let _e4234 = ((_e4219.member * _e4209) + (_e4227.member * _e4217));
let _e4235 = ((_e4219.member_1 * _e4209) + (_e4227.member_1 * _e4217));
let _e4236 = ((_e4219.member_2 * _e4209) + (_e4227.member_2 * _e4217));
let _e4239 = global_1.member.member_2.member_3;
let _e4240 = (_e4239 != 0u);
let _e4242 = global_1.member.member_5;
let _e4249 = select((_e4242.member + _e4234), _e4242.member, _e4240);
let _e4250 = select((_e4242.member_1 + _e4235), _e4242.member_1, _e4240);
let _e4251 = select((_e4242.member_2 + _e4236), _e4242.member_2, _e4240);
let _e4253 = global_1.member.member_6;
let _e4260 = select(_e4253.member, (_e4253.member + _e4234), _e4240);
let _e4261 = select(_e4253.member_1, (_e4253.member_1 + _e4235), _e4240);
let _e4262 = select(_e4253.member_2, (_e4253.member_2 + _e4236), _e4240);
let _e4267 = (((_e4249 * _e4249) + (_e4250 * _e4250)) + (_e4251 * _e4251));
let _e4270 = sqrt(select(0f, _e4267, (_e4267 > 0f)));
let _e4271 = (1f / _e4270);
let _e4272 = (_e4249 * _e4271);
let _e4273 = (_e4250 * _e4271);
let _e4274 = (_e4251 * _e4271);
let _e4275 = (_e575 - _e4260);
let _e4276 = (_e587 - _e4261);
let _e4277 = (_e600 - _e4262);
let _e4282 = (((_e4275 * _e4272) + (_e4276 * _e4273)) + (_e4277 * _e4274));
let _e4287 = (((_e4275 * _e613) + (_e4276 * _e626)) + (_e4277 * _e639));
let _e4292 = (((_e4272 * _e613) + (_e4273 * _e626)) + (_e4274 * _e639));
let _e4295 = ((_e4273 * _e639) - (_e4274 * _e626));
let _e4298 = ((_e4274 * _e613) - (_e4272 * _e639));
let _e4301 = ((_e4272 * _e626) - (_e4273 * _e613));
let _e4306 = (((_e4295 * _e4295) + (_e4298 * _e4298)) + (_e4301 * _e4301));
let _e4309 = (1f / select(1e-9f, _e4306, (_e4306 > 1e-9f)));
let _e4312 = ((_e4282 - (_e4292 * _e4287)) * _e4309);
let _e4315 = (((_e4292 * _e4282) - _e4287) * _e4309);
let _e4321 = -(_e4292);
let _e4324 = global_1.member.member_13.member_2;
let _e4325 = (_e4324 * _e4324);
let _e4329 = ((1f + _e4325) - ((2f * _e4324) * _e4321));
let _e4331 = select(1e-9f, _e4329, (_e4329 > 1e-9f));
let _e4343 = global_1.member.member_13.member_3;
if (_e4343 == 2u) {
let _e4348 = (0.5f - (0.5f * _e4321));
let _e4350 = select(0f, _e4348, (_e4348 > 0f));
let _e4354 = (sqrt(select(0f, _e4350, (_e4350 > 0f))) * 255f);
let _e4355 = (255f - 1f);
let _e4357 = select(0f, _e4354, (_e4354 > 0f));
let _e4359 = select(_e4355, _e4357, (_e4357 < _e4355));
let _e4366 = select(0i, select(select(i32(_e4359), i32(-2147483648), (_e4359 < -2147483600f)), 2147483647i, (_e4359 > 2147483500f)), (_e4359 == _e4359));
let _e4370 = (_e4366 - select(0i, 1i, (_e4359 < f32(_e4366))));
let _e4373 = global_1.member.member_13.member_11;
let _e4374 = bitcast<i32>(_e4373);
let _e4375 = (_e4374 + _e4370);
let _e4377 = (bitcast<i32>(_e265) - 1i);
let _e4379 = select(_e4377, _e4375, (_e4375 < _e4377));
let _e4384 = global_2.member[bitcast<u32>(select(0i, _e4379, (_e4379 > 0i)))];
let _e4386 = (_e4374 + (_e4370 + 1i));
let _e4388 = select(_e4377, _e4386, (_e4386 < _e4377));
let _e4393 = global_2.member[bitcast<u32>(select(0i, _e4388, (_e4388 > 0i)))];
phi_9748_ = (_e4384 + ((_e4393 - _e4384) * (_e4354 - f32(_e4370))));
} else {
phi_9748_ = select(((1f - _e4325) / (_e4331 * sqrt(select(0f, _e4331, (_e4331 > 0f))))), (0.75f * (1f + (_e4321 * _e4321))), (_e4343 == 1u));
}
let _e4400 = phi_9748_;
let _e4406 = global_1.member.member_12.member_12;
let _e4409 = global_1.member.member_12.member_4;
let _e4412 = global_1.member.member_12.member_13;
let _e4418 = global_1.member.member.member;
let _e4420 = (_e4315 / _e691);
local_183 = bitcast<i32>((_e4406 + (_e4409 * _e4412)));
local_184 = _e281;
local_185 = bitcast<i32>(_e4418);
let _e4423 = global_1.member.member_13.member_6;
let _e4424 = f32(_e4423);
let _e4426 = select(0f, _e4420, (_e4420 > 0f));
let _e4429 = (select(1f, _e4426, (_e4426 < 1f)) * _e4424);
let _e4430 = (_e4424 - 1f);
let _e4432 = select(0f, _e4430, (_e4430 > 0f));
let _e4434 = select(0f, _e4429, (_e4429 > 0f));
let _e4436 = select(_e4432, _e4434, (_e4434 < _e4432));
let _e4443 = select(0i, select(select(i32(_e4436), i32(-2147483648), (_e4436 < -2147483600f)), 2147483647i, (_e4436 > 2147483500f)), (_e4436 == _e4436));
let _e4447 = (_e4443 - select(0i, 1i, (_e4436 < f32(_e4443))));
if (_e4447 > 0i) {
let _e4450 = local_183;
let _e4451 = local_185;
let _e4454 = local_184;
let _e4455 = ((_e4450 + ((_e4447 - 1i) * _e4451)) + _e4454);
let _e4457 = (bitcast<i32>(_e268) - 1i);
let _e4459 = select(_e4457, _e4455, (_e4455 < _e4457));
let _e4464 = global_7.member[bitcast<u32>(select(0i, _e4459, (_e4459 > 0i)))];
phi_9854_ = _e4464;
} else {
phi_9854_ = 0f;
}
let _e4466 = phi_9854_;
let _e4467 = local_183;
let _e4468 = local_185;
let _e4471 = local_184;
let _e4472 = ((_e4467 + (_e4447 * _e4468)) + _e4471);
let _e4474 = (bitcast<i32>(_e268) - 1i);
let _e4476 = select(_e4474, _e4472, (_e4472 < _e4474));
let _e4481 = global_7.member[bitcast<u32>(select(0i, _e4476, (_e4476 > 0i)))];
let _e4488 = (_e4188 - _e4177);
let _e4491 = ((_e4312 - _e4177) / select(1e-9f, _e4488, (_e4488 > 1e-9f)));
local_180 = 0i;
local_181 = _e4197;
local_182 = _e4163;
let _e4493 = select(0f, _e4491, (_e4491 > 0f));
let _e4496 = (select(1f, _e4493, (_e4493 < 1f)) * _e4424);
let _e4498 = select(0f, _e4496, (_e4496 > 0f));
let _e4500 = select(_e4432, _e4498, (_e4498 < _e4432));
let _e4507 = select(0i, select(select(i32(_e4500), i32(-2147483648), (_e4500 < -2147483600f)), 2147483647i, (_e4500 > 2147483500f)), (_e4500 == _e4500));
let _e4511 = (_e4507 - select(0i, 1i, (_e4500 < f32(_e4507))));
if (_e4511 > 0i) {
let _e4514 = local_180;
let _e4515 = local_182;
let _e4518 = local_181;
let _e4519 = ((_e4514 + ((_e4511 - 1i) * _e4515)) + _e4518);
let _e4521 = select(_e4474, _e4519, (_e4519 < _e4474));
let _e4526 = global_7.member[bitcast<u32>(select(0i, _e4521, (_e4521 > 0i)))];
phi_9981_ = _e4526;
} else {
phi_9981_ = 0f;
}
let _e4528 = phi_9981_;
let _e4529 = local_180;
let _e4530 = local_182;
let _e4533 = local_181;
let _e4534 = ((_e4529 + (_e4511 * _e4530)) + _e4533);
let _e4536 = select(_e4474, _e4534, (_e4534 < _e4474));
let _e4541 = global_7.member[bitcast<u32>(select(0i, _e4536, (_e4536 > 0i)))];
let _e4547 = ((_e4466 + ((_e4481 - _e4466) * (_e4429 - f32(_e4447)))) + (_e4528 + ((_e4541 - _e4528) * (_e4496 - f32(_e4511)))));
let _e4556 = global_1.member.member_13.member_7;
let _e4557 = bitcast<i32>(_e4556);
let _e4560 = global_1.member.member_13.member_8;
let _e4561 = bitcast<i32>(_e4560);
let _e4564 = global_1.member.member_13.member_9;
let _e4565 = bitcast<i32>(_e4564);
let _e4568 = global_1.member.member_13.member_4;
let _e4574 = global_1.member.member_13.member_5;
let _e4578 = f32(_e4557);
let _e4583 = (((((_e4260 + (_e4272 * _e4312)) - _e4568.member) / (_e4574.member - _e4568.member)) * _e4578) - 0.5f);
let _e4584 = (_e4578 - 1f);
let _e4586 = select(0f, _e4583, (_e4583 > 0f));
let _e4588 = select(_e4584, _e4586, (_e4586 < _e4584));
let _e4589 = f32(_e4561);
let _e4594 = (((((_e4261 + (_e4273 * _e4312)) - _e4568.member_1) / (_e4574.member_1 - _e4568.member_1)) * _e4589) - 0.5f);
let _e4595 = (_e4589 - 1f);
let _e4597 = select(0f, _e4594, (_e4594 > 0f));
let _e4599 = select(_e4595, _e4597, (_e4597 < _e4595));
let _e4600 = f32(_e4565);
let _e4605 = (((((_e4262 + (_e4274 * _e4312)) - _e4568.member_2) / (_e4574.member_2 - _e4568.member_2)) * _e4600) - 0.5f);
let _e4606 = (_e4600 - 1f);
let _e4608 = select(0f, _e4605, (_e4605 > 0f));
let _e4610 = select(_e4606, _e4608, (_e4608 < _e4606));
let _e4612 = select(0f, _e4588, (_e4588 > 0f));
let _e4614 = select(1e6f, _e4612, (_e4612 < 1e6f));
let _e4621 = select(0i, select(select(i32(_e4614), i32(-2147483648), (_e4614 < -2147483600f)), 2147483647i, (_e4614 > 2147483500f)), (_e4614 == _e4614));
let _e4625 = (_e4621 - select(0i, 1i, (_e4614 < f32(_e4621))));
let _e4627 = select(0f, _e4599, (_e4599 > 0f));
let _e4629 = select(1e6f, _e4627, (_e4627 < 1e6f));
let _e4636 = select(0i, select(select(i32(_e4629), i32(-2147483648), (_e4629 < -2147483600f)), 2147483647i, (_e4629 > 2147483500f)), (_e4629 == _e4629));
let _e4640 = (_e4636 - select(0i, 1i, (_e4629 < f32(_e4636))));
let _e4642 = select(0f, _e4610, (_e4610 > 0f));
let _e4644 = select(1e6f, _e4642, (_e4642 < 1e6f));
let _e4651 = select(0i, select(select(i32(_e4644), i32(-2147483648), (_e4644 < -2147483600f)), 2147483647i, (_e4644 > 2147483500f)), (_e4644 == _e4644));
let _e4655 = (_e4651 - select(0i, 1i, (_e4644 < f32(_e4651))));
let _e4659 = (_e4599 - f32(_e4640));
let _e4661 = (_e4610 - f32(_e4655));
local_178 = (_e4588 - f32(_e4625));
let _e4662 = (_e4625 + 1i);
let _e4664 = select(_e4662, 0i, (_e4662 < 0i));
if (_e4664 >= _e4557) {
phi_10129_ = (_e4557 - 1i);
} else {
phi_10129_ = _e4664;
}
let _e4668 = phi_10129_;
local_179 = (_e4668 - _e4625);
let _e4670 = (_e4640 + 1i);
let _e4672 = select(_e4670, 0i, (_e4670 < 0i));
if (_e4672 >= _e4561) {
phi_10142_ = (_e4561 - 1i);
} else {
phi_10142_ = _e4672;
}
let _e4676 = phi_10142_;
let _e4678 = ((_e4676 - _e4640) * _e4557);
let _e4679 = (_e4655 + 1i);
let _e4681 = select(_e4679, 0i, (_e4679 < 0i));
if (_e4681 >= _e4565) {
phi_10156_ = (_e4565 - 1i);
} else {
phi_10156_ = _e4681;
}
let _e4685 = phi_10156_;
let _e4691 = global_1.member.member_13.member_10;
let _e4697 = ((bitcast<i32>(_e4691) + (((_e4655 * _e4561) + _e4640) * _e4557)) + _e4625);
let _e4699 = (bitcast<i32>(_e265) - 1i);
let _e4701 = select(_e4699, _e4697, (_e4697 < _e4699));
let _e4706 = global_2.member[bitcast<u32>(select(0i, _e4701, (_e4701 > 0i)))];
let _e4707 = local_178;
let _e4710 = local_179;
let _e4711 = (_e4697 + _e4710);
let _e4713 = select(_e4699, _e4711, (_e4711 < _e4699));
let _e4718 = global_2.member[bitcast<u32>(select(0i, _e4713, (_e4713 > 0i)))];
let _e4719 = local_178;
let _e4722 = (1f - _e4659);
let _e4724 = (_e4697 + _e4678);
let _e4726 = select(_e4699, _e4724, (_e4724 < _e4699));
let _e4731 = global_2.member[bitcast<u32>(select(0i, _e4726, (_e4726 > 0i)))];
let _e4732 = local_178;
let _e4735 = local_179;
let _e4736 = (_e4724 + _e4735);
let _e4738 = select(_e4699, _e4736, (_e4736 < _e4699));
let _e4743 = global_2.member[bitcast<u32>(select(0i, _e4738, (_e4738 > 0i)))];
let _e4744 = local_178;
let _e4749 = (_e4697 + (((_e4685 - _e4655) * _e4557) * _e4561));
let _e4751 = select(_e4699, _e4749, (_e4749 < _e4699));
let _e4756 = global_2.member[bitcast<u32>(select(0i, _e4751, (_e4751 > 0i)))];
let _e4757 = local_178;
let _e4760 = local_179;
let _e4761 = (_e4749 + _e4760);
let _e4763 = select(_e4699, _e4761, (_e4761 < _e4699));
let _e4768 = global_2.member[bitcast<u32>(select(0i, _e4763, (_e4763 > 0i)))];
let _e4769 = local_178;
let _e4773 = (_e4749 + _e4678);
let _e4775 = select(_e4699, _e4773, (_e4773 < _e4699));
let _e4780 = global_2.member[bitcast<u32>(select(0i, _e4775, (_e4775 > 0i)))];
let _e4781 = local_178;
let _e4784 = local_179;
let _e4785 = (_e4773 + _e4784);
let _e4787 = select(_e4699, _e4785, (_e4785 < _e4699));
let _e4792 = global_2.member[bitcast<u32>(select(0i, _e4787, (_e4787 > 0i)))];
let _e4793 = local_178;
let _e4802 = ((_e4270 * (_e4400 * (0.25f / 3.1415927f))) * ((((((_e4706 * (1f - _e4707)) + (_e4718 * _e4719)) * _e4722) + (((_e4731 * (1f - _e4732)) + (_e4743 * _e4744)) * _e4659)) * (1f - _e4661)) + (((((_e4756 * (1f - _e4757)) + (_e4768 * _e4769)) * _e4722) + (((_e4780 * (1f - _e4781)) + (_e4792 * _e4793)) * _e4659)) * _e4661)));
let _e4805 = global_1.member.member_13.member_1;
let _e4814 = global_1.member.member_13.member;
let _e4819 = -((_e4814.member * _e4547));
let _e4821 = select(-87f, _e4819, (_e4819 > -87f));
let _e4823 = select(88f, _e4821, (_e4821 < 88f));
let _e4825 = ((_e4823 * 1.442695f) + 0.5f);
let _e4827 = select(-127f, _e4825, (_e4825 > -127f));
let _e4829 = select(128f, _e4827, (_e4827 < 128f));
let _e4836 = select(0i, select(select(i32(_e4829), i32(-2147483648), (_e4829 < -2147483600f)), 2147483647i, (_e4829 > 2147483500f)), (_e4829 == _e4829));
let _e4840 = (_e4836 - select(0i, 1i, (_e4829 < f32(_e4836))));
let _e4841 = f32(_e4840);
let _e4845 = ((_e4823 - (_e4841 * 0.6933594f)) - (_e4841 * -2.1219444e-4f));
let _e4867 = -((_e4814.member_1 * _e4547));
let _e4869 = select(-87f, _e4867, (_e4867 > -87f));
let _e4871 = select(88f, _e4869, (_e4869 < 88f));
let _e4873 = ((_e4871 * 1.442695f) + 0.5f);
let _e4875 = select(-127f, _e4873, (_e4873 > -127f));
let _e4877 = select(128f, _e4875, (_e4875 < 128f));
let _e4884 = select(0i, select(select(i32(_e4877), i32(-2147483648), (_e4877 < -2147483600f)), 2147483647i, (_e4877 > 2147483500f)), (_e4877 == _e4877));
let _e4888 = (_e4884 - select(0i, 1i, (_e4877 < f32(_e4884))));
let _e4889 = f32(_e4888);
let _e4893 = ((_e4871 - (_e4889 * 0.6933594f)) - (_e4889 * -2.1219444e-4f));
let _e4915 = -((_e4814.member_2 * _e4547));
let _e4917 = select(-87f, _e4915, (_e4915 > -87f));
let _e4919 = select(88f, _e4917, (_e4917 < 88f));
let _e4921 = ((_e4919 * 1.442695f) + 0.5f);
let _e4923 = select(-127f, _e4921, (_e4921 > -127f));
let _e4925 = select(128f, _e4923, (_e4923 < 128f));
let _e4932 = select(0i, select(select(i32(_e4925), i32(-2147483648), (_e4925 < -2147483600f)), 2147483647i, (_e4925 > 2147483500f)), (_e4925 == _e4925));
let _e4936 = (_e4932 - select(0i, 1i, (_e4925 < f32(_e4932))));
let _e4937 = f32(_e4936);
let _e4941 = ((_e4919 - (_e4937 * 0.6933594f)) - (_e4937 * -2.1219444e-4f));
let _e4968 = select(0f, _e4312, (((_e4315 >= 0f) && (_e4315 < _e691)) && (_e4312 > 0f)));
let _e4969 = (_e766 & 31u);
let _e4971 = (1u << bitcast<u32>(_e4969));
let _e4980 = bitcast<i32>((((_e927 + _e4971) - 1u) >> bitcast<u32>(_e4969)));
let _e4981 = bitcast<i32>((((_e930 + _e4971) - 1u) >> bitcast<u32>(_e4969)));
if _e453 {
phi_10615_ = type_23(_e4981, _e4980);
} else {
phi_10615_ = type_23(_e4980, _e4981);
}
let _e4985 = phi_10615_;
let _e4990 = f32((1i << bitcast<u32>(_e4969)));
let _e4991 = (1f / _e4990);
let _e4993 = ((_e4015 * _e4991) - 0.5f);
let _e4995 = ((_e4108 * _e4991) - 0.5f);
let _e4997 = select(-1f, _e4993, (_e4993 > -1f));
let _e4999 = select(1e6f, _e4997, (_e4997 < 1e6f));
let _e5006 = select(0i, select(select(i32(_e4999), i32(-2147483648), (_e4999 < -2147483600f)), 2147483647i, (_e4999 > 2147483500f)), (_e4999 == _e4999));
let _e5010 = (_e5006 - select(0i, 1i, (_e4999 < f32(_e5006))));
let _e5012 = select(-1f, _e4995, (_e4995 > -1f));
let _e5014 = select(1e6f, _e5012, (_e5012 < 1e6f));
let _e5021 = select(0i, select(select(i32(_e5014), i32(-2147483648), (_e5014 < -2147483600f)), 2147483647i, (_e5014 > 2147483500f)), (_e5014 == _e5014));
let _e5025 = (_e5021 - select(0i, 1i, (_e5014 < f32(_e5021))));
let _e5027 = (_e4993 - f32(_e5010));
let _e5029 = (_e4995 - f32(_e5025));
let _e5030 = (1f - _e5027);
let _e5031 = (1f - _e5029);
let _e5034 = select(_e5010, 0i, (_e5010 < 0i));
let _e5035 = (_e5034 >= _e4985.member);
if _e5035 {
phi_10693_ = (_e4985.member - 1i);
} else {
phi_10693_ = _e5034;
}
let _e5038 = phi_10693_;
let _e5040 = select(_e5025, 0i, (_e5025 < 0i));
let _e5041 = (_e5040 >= _e4985.member_1);
if _e5041 {
phi_10704_ = (_e4985.member_1 - 1i);
} else {
phi_10704_ = _e5040;
}
let _e5044 = phi_10704_;
let _e5048 = (((f32(_e5038) + 0.5f) * _e4990) - 0.5f);
let _e5052 = (((f32(_e5044) + 0.5f) * _e4990) - 0.5f);
if _e453 {
phi_10732_ = type_23(_e5044, _e5038);
} else {
phi_10732_ = type_23(_e5038, _e5044);
}
let _e5058 = phi_10732_;
let _e5064 = bitcast<i32>(((_e927 + 1u) >> bitcast<u32>(1u)));
let _e5067 = global_1.member.member_18.member_6;
let _e5070 = global_1.member.member_18.member_7;
let _e5073 = global_1.member.member_18.member_8;
if _e982 {
phi_10783_ = 0u;
} else {
if (_e766 == 1u) {
phi_10782_ = 0u;
} else {
if (_e766 == 2u) {
phi_10781_ = _e5067;
} else {
phi_10781_ = select(_e5073, _e5070, (_e766 == 3u));
}
let _e5079 = phi_10781_;
phi_10782_ = _e5079;
}
let _e5081 = phi_10782_;
phi_10783_ = _e5081;
}
let _e5083 = phi_10783_;
local_176 = (((bitcast<i32>(_e5083) + _e5058.member_1) * _e5064) + _e5058.member);
let _e5088 = local_176;
let _e5090 = (bitcast<i32>(_e262) - 1i);
let _e5092 = select(_e5090, _e5088, (_e5088 < _e5090));
let _e5097 = global_6.member[bitcast<u32>(select(0i, _e5092, (_e5092 > 0i)))];
let _e5102 = (((((select(_e5048, _e5052, _e453) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e5107 = ((1f - (((select(_e5052, _e5048, _e453) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e5114 = ((_e4219.member * _e5102) + (_e4227.member * _e5107));
let _e5115 = ((_e4219.member_1 * _e5102) + (_e4227.member_1 * _e5107));
let _e5116 = ((_e4219.member_2 * _e5102) + (_e4227.member_2 * _e5107));
let _e5120 = select((_e4242.member + _e5114), _e4242.member, _e4240);
let _e5121 = select((_e4242.member_1 + _e5115), _e4242.member_1, _e4240);
let _e5122 = select((_e4242.member_2 + _e5116), _e4242.member_2, _e4240);
let _e5133 = (((_e5120 * _e5120) + (_e5121 * _e5121)) + (_e5122 * _e5122));
let _e5137 = (1f / sqrt(select(0f, _e5133, (_e5133 > 0f))));
let _e5138 = (_e5120 * _e5137);
let _e5139 = (_e5121 * _e5137);
let _e5140 = (_e5122 * _e5137);
let _e5141 = (_e575 - select(_e4253.member, (_e4253.member + _e5114), _e4240));
let _e5142 = (_e587 - select(_e4253.member_1, (_e4253.member_1 + _e5115), _e4240));
let _e5143 = (_e600 - select(_e4253.member_2, (_e4253.member_2 + _e5116), _e4240));
let _e5148 = (((_e5141 * _e5138) + (_e5142 * _e5139)) + (_e5143 * _e5140));
let _e5153 = (((_e5141 * _e613) + (_e5142 * _e626)) + (_e5143 * _e639));
let _e5158 = (((_e5138 * _e613) + (_e5139 * _e626)) + (_e5140 * _e639));
let _e5161 = ((_e5139 * _e639) - (_e5140 * _e626));
let _e5164 = ((_e5140 * _e613) - (_e5138 * _e639));
let _e5167 = ((_e5138 * _e626) - (_e5139 * _e613));
let _e5172 = (((_e5161 * _e5161) + (_e5164 * _e5164)) + (_e5167 * _e5167));
let _e5175 = (1f / select(1e-9f, _e5172, (_e5172 > 1e-9f)));
let _e5178 = ((_e5148 - (_e5158 * _e5153)) * _e5175);
let _e5181 = (((_e5158 * _e5148) - _e5153) * _e5175);
let _e5187 = select(0f, _e5178, (((_e5181 >= 0f) && (_e5181 < _e691)) && (_e5178 > 0f)));
let _e5189 = (_e5038 << bitcast<u32>(_e4969));
let _e5201 = (_e5010 + 1i);
let _e5204 = select(_e5201, 0i, (_e5201 < 0i));
let _e5205 = (_e5204 >= _e4985.member);
if _e5205 {
phi_11444_ = (_e4985.member - 1i);
} else {
phi_11444_ = _e5204;
}
let _e5208 = phi_11444_;
if _e5041 {
phi_11455_ = (_e4985.member_1 - 1i);
} else {
phi_11455_ = _e5040;
}
let _e5211 = phi_11455_;
let _e5215 = (((f32(_e5208) + 0.5f) * _e4990) - 0.5f);
let _e5219 = (((f32(_e5211) + 0.5f) * _e4990) - 0.5f);
if _e453 {
phi_11483_ = type_23(_e5211, _e5208);
} else {
phi_11483_ = type_23(_e5208, _e5211);
}
let _e5225 = phi_11483_;
if _e982 {
phi_11534_ = 0u;
} else {
if (_e766 == 1u) {
phi_11533_ = 0u;
} else {
if (_e766 == 2u) {
phi_11532_ = _e5067;
} else {
phi_11532_ = select(_e5073, _e5070, (_e766 == 3u));
}
let _e5233 = phi_11532_;
phi_11533_ = _e5233;
}
let _e5235 = phi_11533_;
phi_11534_ = _e5235;
}
let _e5237 = phi_11534_;
local_174 = (((bitcast<i32>(_e5237) + _e5225.member_1) * _e5064) + _e5225.member);
let _e5242 = local_174;
let _e5244 = select(_e5090, _e5242, (_e5242 < _e5090));
let _e5249 = global_6.member[bitcast<u32>(select(0i, _e5244, (_e5244 > 0i)))];
let _e5254 = (((((select(_e5215, _e5219, _e453) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e5259 = ((1f - (((select(_e5219, _e5215, _e453) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e5266 = ((_e4219.member * _e5254) + (_e4227.member * _e5259));
let _e5267 = ((_e4219.member_1 * _e5254) + (_e4227.member_1 * _e5259));
let _e5268 = ((_e4219.member_2 * _e5254) + (_e4227.member_2 * _e5259));
let _e5272 = select((_e4242.member + _e5266), _e4242.member, _e4240);
let _e5273 = select((_e4242.member_1 + _e5267), _e4242.member_1, _e4240);
let _e5274 = select((_e4242.member_2 + _e5268), _e4242.member_2, _e4240);
let _e5285 = (((_e5272 * _e5272) + (_e5273 * _e5273)) + (_e5274 * _e5274));
let _e5289 = (1f / sqrt(select(0f, _e5285, (_e5285 > 0f))));
let _e5290 = (_e5272 * _e5289);
let _e5291 = (_e5273 * _e5289);
let _e5292 = (_e5274 * _e5289);
let _e5293 = (_e575 - select(_e4253.member, (_e4253.member + _e5266), _e4240));
let _e5294 = (_e587 - select(_e4253.member_1, (_e4253.member_1 + _e5267), _e4240));
let _e5295 = (_e600 - select(_e4253.member_2, (_e4253.member_2 + _e5268), _e4240));
let _e5300 = (((_e5293 * _e5290) + (_e5294 * _e5291)) + (_e5295 * _e5292));
let _e5305 = (((_e5293 * _e613) + (_e5294 * _e626)) + (_e5295 * _e639));
let _e5310 = (((_e5290 * _e613) + (_e5291 * _e626)) + (_e5292 * _e639));
let _e5313 = ((_e5291 * _e639) - (_e5292 * _e626));
let _e5316 = ((_e5292 * _e613) - (_e5290 * _e639));
let _e5319 = ((_e5290 * _e626) - (_e5291 * _e613));
let _e5324 = (((_e5313 * _e5313) + (_e5316 * _e5316)) + (_e5319 * _e5319));
let _e5327 = (1f / select(1e-9f, _e5324, (_e5324 > 1e-9f)));
let _e5330 = ((_e5300 - (_e5310 * _e5305)) * _e5327);
let _e5333 = (((_e5310 * _e5300) - _e5305) * _e5327);
let _e5339 = select(0f, _e5330, (((_e5333 >= 0f) && (_e5333 < _e691)) && (_e5330 > 0f)));
let _e5341 = (_e5208 << bitcast<u32>(_e4969));
let _e5353 = (_e5025 + 1i);
if _e5035 {
phi_12195_ = (_e4985.member - 1i);
} else {
phi_12195_ = _e5034;
}
let _e5357 = phi_12195_;
let _e5359 = select(_e5353, 0i, (_e5353 < 0i));
let _e5360 = (_e5359 >= _e4985.member_1);
if _e5360 {
phi_12206_ = (_e4985.member_1 - 1i);
} else {
phi_12206_ = _e5359;
}
let _e5363 = phi_12206_;
let _e5367 = (((f32(_e5357) + 0.5f) * _e4990) - 0.5f);
let _e5371 = (((f32(_e5363) + 0.5f) * _e4990) - 0.5f);
if _e453 {
phi_12234_ = type_23(_e5363, _e5357);
} else {
phi_12234_ = type_23(_e5357, _e5363);
}
let _e5377 = phi_12234_;
if _e982 {
phi_12285_ = 0u;
} else {
if (_e766 == 1u) {
phi_12284_ = 0u;
} else {
if (_e766 == 2u) {
phi_12283_ = _e5067;
} else {
phi_12283_ = select(_e5073, _e5070, (_e766 == 3u));
}
let _e5385 = phi_12283_;
phi_12284_ = _e5385;
}
let _e5387 = phi_12284_;
phi_12285_ = _e5387;
}
let _e5389 = phi_12285_;
local_172 = (((bitcast<i32>(_e5389) + _e5377.member_1) * _e5064) + _e5377.member);
let _e5394 = local_172;
let _e5396 = select(_e5090, _e5394, (_e5394 < _e5090));
let _e5401 = global_6.member[bitcast<u32>(select(0i, _e5396, (_e5396 > 0i)))];
let _e5406 = (((((select(_e5367, _e5371, _e453) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e5411 = ((1f - (((select(_e5371, _e5367, _e453) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e5418 = ((_e4219.member * _e5406) + (_e4227.member * _e5411));
let _e5419 = ((_e4219.member_1 * _e5406) + (_e4227.member_1 * _e5411));
let _e5420 = ((_e4219.member_2 * _e5406) + (_e4227.member_2 * _e5411));
let _e5424 = select((_e4242.member + _e5418), _e4242.member, _e4240);
let _e5425 = select((_e4242.member_1 + _e5419), _e4242.member_1, _e4240);
let _e5426 = select((_e4242.member_2 + _e5420), _e4242.member_2, _e4240);
let _e5437 = (((_e5424 * _e5424) + (_e5425 * _e5425)) + (_e5426 * _e5426));
let _e5441 = (1f / sqrt(select(0f, _e5437, (_e5437 > 0f))));
let _e5442 = (_e5424 * _e5441);
let _e5443 = (_e5425 * _e5441);
let _e5444 = (_e5426 * _e5441);
let _e5445 = (_e575 - select(_e4253.member, (_e4253.member + _e5418), _e4240));
let _e5446 = (_e587 - select(_e4253.member_1, (_e4253.member_1 + _e5419), _e4240));
let _e5447 = (_e600 - select(_e4253.member_2, (_e4253.member_2 + _e5420), _e4240));
let _e5452 = (((_e5445 * _e5442) + (_e5446 * _e5443)) + (_e5447 * _e5444));
let _e5457 = (((_e5445 * _e613) + (_e5446 * _e626)) + (_e5447 * _e639));
let _e5462 = (((_e5442 * _e613) + (_e5443 * _e626)) + (_e5444 * _e639));
let _e5465 = ((_e5443 * _e639) - (_e5444 * _e626));
let _e5468 = ((_e5444 * _e613) - (_e5442 * _e639));
let _e5471 = ((_e5442 * _e626) - (_e5443 * _e613));
let _e5476 = (((_e5465 * _e5465) + (_e5468 * _e5468)) + (_e5471 * _e5471));
let _e5479 = (1f / select(1e-9f, _e5476, (_e5476 > 1e-9f)));
let _e5482 = ((_e5452 - (_e5462 * _e5457)) * _e5479);
let _e5485 = (((_e5462 * _e5452) - _e5457) * _e5479);
let _e5491 = select(0f, _e5482, (((_e5485 >= 0f) && (_e5485 < _e691)) && (_e5482 > 0f)));
let _e5493 = (_e5357 << bitcast<u32>(_e4969));
if _e5205 {
phi_12946_ = (_e4985.member - 1i);
} else {
phi_12946_ = _e5204;
}
let _e5508 = phi_12946_;
if _e5360 {
phi_12957_ = (_e4985.member_1 - 1i);
} else {
phi_12957_ = _e5359;
}
let _e5511 = phi_12957_;
let _e5515 = (((f32(_e5508) + 0.5f) * _e4990) - 0.5f);
let _e5519 = (((f32(_e5511) + 0.5f) * _e4990) - 0.5f);
if _e453 {
phi_12985_ = type_23(_e5511, _e5508);
} else {
phi_12985_ = type_23(_e5508, _e5511);
}
let _e5525 = phi_12985_;
if _e982 {
phi_13036_ = 0u;
} else {
if (_e766 == 1u) {
phi_13035_ = 0u;
} else {
if (_e766 == 2u) {
phi_13034_ = _e5067;
} else {
phi_13034_ = select(_e5073, _e5070, (_e766 == 3u));
}
let _e5533 = phi_13034_;
phi_13035_ = _e5533;
}
let _e5535 = phi_13035_;
phi_13036_ = _e5535;
}
let _e5537 = phi_13036_;
local_170 = (((bitcast<i32>(_e5537) + _e5525.member_1) * _e5064) + _e5525.member);
let _e5542 = local_170;
let _e5544 = select(_e5090, _e5542, (_e5542 < _e5090));
let _e5549 = global_6.member[bitcast<u32>(select(0i, _e5544, (_e5544 > 0i)))];
let _e5554 = (((((select(_e5515, _e5519, _e453) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e5559 = ((1f - (((select(_e5519, _e5515, _e453) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e5566 = ((_e4219.member * _e5554) + (_e4227.member * _e5559));
let _e5567 = ((_e4219.member_1 * _e5554) + (_e4227.member_1 * _e5559));
let _e5568 = ((_e4219.member_2 * _e5554) + (_e4227.member_2 * _e5559));
let _e5572 = select((_e4242.member + _e5566), _e4242.member, _e4240);
let _e5573 = select((_e4242.member_1 + _e5567), _e4242.member_1, _e4240);
let _e5574 = select((_e4242.member_2 + _e5568), _e4242.member_2, _e4240);
let _e5585 = (((_e5572 * _e5572) + (_e5573 * _e5573)) + (_e5574 * _e5574));
let _e5589 = (1f / sqrt(select(0f, _e5585, (_e5585 > 0f))));
let _e5590 = (_e5572 * _e5589);
let _e5591 = (_e5573 * _e5589);
let _e5592 = (_e5574 * _e5589);
let _e5593 = (_e575 - select(_e4253.member, (_e4253.member + _e5566), _e4240));
let _e5594 = (_e587 - select(_e4253.member_1, (_e4253.member_1 + _e5567), _e4240));
let _e5595 = (_e600 - select(_e4253.member_2, (_e4253.member_2 + _e5568), _e4240));
let _e5600 = (((_e5593 * _e5590) + (_e5594 * _e5591)) + (_e5595 * _e5592));
let _e5605 = (((_e5593 * _e613) + (_e5594 * _e626)) + (_e5595 * _e639));
let _e5610 = (((_e5590 * _e613) + (_e5591 * _e626)) + (_e5592 * _e639));
let _e5613 = ((_e5591 * _e639) - (_e5592 * _e626));
let _e5616 = ((_e5592 * _e613) - (_e5590 * _e639));
let _e5619 = ((_e5590 * _e626) - (_e5591 * _e613));
let _e5624 = (((_e5613 * _e5613) + (_e5616 * _e5616)) + (_e5619 * _e5619));
let _e5627 = (1f / select(1e-9f, _e5624, (_e5624 > 1e-9f)));
let _e5630 = ((_e5600 - (_e5610 * _e5605)) * _e5627);
let _e5633 = (((_e5610 * _e5600) - _e5605) * _e5627);
let _e5639 = select(0f, _e5630, (((_e5633 >= 0f) && (_e5633 < _e691)) && (_e5630 > 0f)));
let _e5641 = (_e5508 << bitcast<u32>(_e4969));
let _e5653 = select(((((1f - select(0f, (_e5030 * _e5031), (((select(select(_e766, _e923, (_e5189 >= _e692)), _e845, (_e5189 < _e298)) == _e766) && (_e5187 > 0f)) && (_e5187 < _e5097)))) - select(0f, (_e5027 * _e5031), (((select(select(_e766, _e923, (_e5341 >= _e692)), _e845, (_e5341 < _e298)) == _e766) && (_e5339 > 0f)) && (_e5339 < _e5249)))) - select(0f, (_e5030 * _e5029), (((select(select(_e766, _e923, (_e5493 >= _e692)), _e845, (_e5493 < _e298)) == _e766) && (_e5491 > 0f)) && (_e5491 < _e5401)))) - select(0f, (_e5027 * _e5029), (((select(select(_e766, _e923, (_e5641 >= _e692)), _e845, (_e5641 < _e298)) == _e766) && (_e5639 > 0f)) && (_e5639 < _e5549)))), 1f, _e982);
let _e5654 = (_e984 & 31u);
let _e5656 = (1u << bitcast<u32>(_e5654));
let _e5665 = bitcast<i32>((((_e927 + _e5656) - 1u) >> bitcast<u32>(_e5654)));
let _e5666 = bitcast<i32>((((_e930 + _e5656) - 1u) >> bitcast<u32>(_e5654)));
if _e453 {
phi_13715_ = type_23(_e5666, _e5665);
} else {
phi_13715_ = type_23(_e5665, _e5666);
}
let _e5670 = phi_13715_;
let _e5675 = f32((1i << bitcast<u32>(_e5654)));
let _e5676 = (1f / _e5675);
let _e5678 = ((_e4015 * _e5676) - 0.5f);
let _e5680 = ((_e4108 * _e5676) - 0.5f);
let _e5682 = select(-1f, _e5678, (_e5678 > -1f));
let _e5684 = select(1e6f, _e5682, (_e5682 < 1e6f));
let _e5691 = select(0i, select(select(i32(_e5684), i32(-2147483648), (_e5684 < -2147483600f)), 2147483647i, (_e5684 > 2147483500f)), (_e5684 == _e5684));
let _e5695 = (_e5691 - select(0i, 1i, (_e5684 < f32(_e5691))));
let _e5697 = select(-1f, _e5680, (_e5680 > -1f));
let _e5699 = select(1e6f, _e5697, (_e5697 < 1e6f));
let _e5706 = select(0i, select(select(i32(_e5699), i32(-2147483648), (_e5699 < -2147483600f)), 2147483647i, (_e5699 > 2147483500f)), (_e5699 == _e5699));
let _e5710 = (_e5706 - select(0i, 1i, (_e5699 < f32(_e5706))));
let _e5712 = (_e5678 - f32(_e5695));
let _e5714 = (_e5680 - f32(_e5710));
let _e5715 = (1f - _e5712);
let _e5716 = (1f - _e5714);
let _e5719 = select(_e5695, 0i, (_e5695 < 0i));
let _e5720 = (_e5719 >= _e5670.member);
if _e5720 {
phi_13793_ = (_e5670.member - 1i);
} else {
phi_13793_ = _e5719;
}
let _e5723 = phi_13793_;
let _e5725 = select(_e5710, 0i, (_e5710 < 0i));
let _e5726 = (_e5725 >= _e5670.member_1);
if _e5726 {
phi_13804_ = (_e5670.member_1 - 1i);
} else {
phi_13804_ = _e5725;
}
let _e5729 = phi_13804_;
let _e5733 = (((f32(_e5723) + 0.5f) * _e5675) - 0.5f);
let _e5737 = (((f32(_e5729) + 0.5f) * _e5675) - 0.5f);
if _e453 {
phi_13832_ = type_23(_e5729, _e5723);
} else {
phi_13832_ = type_23(_e5723, _e5729);
}
let _e5743 = phi_13832_;
let _e5746 = (_e984 == 0u);
if _e5746 {
phi_13883_ = 0u;
} else {
if (_e984 == 1u) {
phi_13882_ = 0u;
} else {
if (_e984 == 2u) {
phi_13881_ = _e5067;
} else {
phi_13881_ = select(_e5073, _e5070, (_e984 == 3u));
}
let _e5752 = phi_13881_;
phi_13882_ = _e5752;
}
let _e5754 = phi_13882_;
phi_13883_ = _e5754;
}
let _e5756 = phi_13883_;
local_168 = (((bitcast<i32>(_e5756) + _e5743.member_1) * _e5064) + _e5743.member);
let _e5761 = local_168;
let _e5763 = select(_e5090, _e5761, (_e5761 < _e5090));
let _e5768 = global_6.member[bitcast<u32>(select(0i, _e5763, (_e5763 > 0i)))];
let _e5773 = (((((select(_e5733, _e5737, _e453) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e5778 = ((1f - (((select(_e5737, _e5733, _e453) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e5785 = ((_e4219.member * _e5773) + (_e4227.member * _e5778));
let _e5786 = ((_e4219.member_1 * _e5773) + (_e4227.member_1 * _e5778));
let _e5787 = ((_e4219.member_2 * _e5773) + (_e4227.member_2 * _e5778));
let _e5791 = select((_e4242.member + _e5785), _e4242.member, _e4240);
let _e5792 = select((_e4242.member_1 + _e5786), _e4242.member_1, _e4240);
let _e5793 = select((_e4242.member_2 + _e5787), _e4242.member_2, _e4240);
let _e5804 = (((_e5791 * _e5791) + (_e5792 * _e5792)) + (_e5793 * _e5793));
let _e5808 = (1f / sqrt(select(0f, _e5804, (_e5804 > 0f))));
let _e5809 = (_e5791 * _e5808);
let _e5810 = (_e5792 * _e5808);
let _e5811 = (_e5793 * _e5808);
let _e5812 = (_e575 - select(_e4253.member, (_e4253.member + _e5785), _e4240));
let _e5813 = (_e587 - select(_e4253.member_1, (_e4253.member_1 + _e5786), _e4240));
let _e5814 = (_e600 - select(_e4253.member_2, (_e4253.member_2 + _e5787), _e4240));
let _e5819 = (((_e5812 * _e5809) + (_e5813 * _e5810)) + (_e5814 * _e5811));
let _e5824 = (((_e5812 * _e613) + (_e5813 * _e626)) + (_e5814 * _e639));
let _e5829 = (((_e5809 * _e613) + (_e5810 * _e626)) + (_e5811 * _e639));
let _e5832 = ((_e5810 * _e639) - (_e5811 * _e626));
let _e5835 = ((_e5811 * _e613) - (_e5809 * _e639));
let _e5838 = ((_e5809 * _e626) - (_e5810 * _e613));
let _e5843 = (((_e5832 * _e5832) + (_e5835 * _e5835)) + (_e5838 * _e5838));
let _e5846 = (1f / select(1e-9f, _e5843, (_e5843 > 1e-9f)));
let _e5849 = ((_e5819 - (_e5829 * _e5824)) * _e5846);
let _e5852 = (((_e5829 * _e5819) - _e5824) * _e5846);
let _e5858 = select(0f, _e5849, (((_e5852 >= 0f) && (_e5852 < _e691)) && (_e5849 > 0f)));
let _e5860 = (_e5723 << bitcast<u32>(_e5654));
let _e5872 = (_e5695 + 1i);
let _e5875 = select(_e5872, 0i, (_e5872 < 0i));
let _e5876 = (_e5875 >= _e5670.member);
if _e5876 {
phi_14544_ = (_e5670.member - 1i);
} else {
phi_14544_ = _e5875;
}
let _e5879 = phi_14544_;
if _e5726 {
phi_14555_ = (_e5670.member_1 - 1i);
} else {
phi_14555_ = _e5725;
}
let _e5882 = phi_14555_;
let _e5886 = (((f32(_e5879) + 0.5f) * _e5675) - 0.5f);
let _e5890 = (((f32(_e5882) + 0.5f) * _e5675) - 0.5f);
if _e453 {
phi_14583_ = type_23(_e5882, _e5879);
} else {
phi_14583_ = type_23(_e5879, _e5882);
}
let _e5896 = phi_14583_;
if _e5746 {
phi_14634_ = 0u;
} else {
if (_e984 == 1u) {
phi_14633_ = 0u;
} else {
if (_e984 == 2u) {
phi_14632_ = _e5067;
} else {
phi_14632_ = select(_e5073, _e5070, (_e984 == 3u));
}
let _e5904 = phi_14632_;
phi_14633_ = _e5904;
}
let _e5906 = phi_14633_;
phi_14634_ = _e5906;
}
let _e5908 = phi_14634_;
local_166 = (((bitcast<i32>(_e5908) + _e5896.member_1) * _e5064) + _e5896.member);
let _e5913 = local_166;
let _e5915 = select(_e5090, _e5913, (_e5913 < _e5090));
let _e5920 = global_6.member[bitcast<u32>(select(0i, _e5915, (_e5915 > 0i)))];
let _e5925 = (((((select(_e5886, _e5890, _e453) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e5930 = ((1f - (((select(_e5890, _e5886, _e453) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e5937 = ((_e4219.member * _e5925) + (_e4227.member * _e5930));
let _e5938 = ((_e4219.member_1 * _e5925) + (_e4227.member_1 * _e5930));
let _e5939 = ((_e4219.member_2 * _e5925) + (_e4227.member_2 * _e5930));
let _e5943 = select((_e4242.member + _e5937), _e4242.member, _e4240);
let _e5944 = select((_e4242.member_1 + _e5938), _e4242.member_1, _e4240);
let _e5945 = select((_e4242.member_2 + _e5939), _e4242.member_2, _e4240);
let _e5956 = (((_e5943 * _e5943) + (_e5944 * _e5944)) + (_e5945 * _e5945));
let _e5960 = (1f / sqrt(select(0f, _e5956, (_e5956 > 0f))));
let _e5961 = (_e5943 * _e5960);
let _e5962 = (_e5944 * _e5960);
let _e5963 = (_e5945 * _e5960);
let _e5964 = (_e575 - select(_e4253.member, (_e4253.member + _e5937), _e4240));
let _e5965 = (_e587 - select(_e4253.member_1, (_e4253.member_1 + _e5938), _e4240));
let _e5966 = (_e600 - select(_e4253.member_2, (_e4253.member_2 + _e5939), _e4240));
let _e5971 = (((_e5964 * _e5961) + (_e5965 * _e5962)) + (_e5966 * _e5963));
let _e5976 = (((_e5964 * _e613) + (_e5965 * _e626)) + (_e5966 * _e639));
let _e5981 = (((_e5961 * _e613) + (_e5962 * _e626)) + (_e5963 * _e639));
let _e5984 = ((_e5962 * _e639) - (_e5963 * _e626));
let _e5987 = ((_e5963 * _e613) - (_e5961 * _e639));
let _e5990 = ((_e5961 * _e626) - (_e5962 * _e613));
let _e5995 = (((_e5984 * _e5984) + (_e5987 * _e5987)) + (_e5990 * _e5990));
let _e5998 = (1f / select(1e-9f, _e5995, (_e5995 > 1e-9f)));
let _e6001 = ((_e5971 - (_e5981 * _e5976)) * _e5998);
let _e6004 = (((_e5981 * _e5971) - _e5976) * _e5998);
let _e6010 = select(0f, _e6001, (((_e6004 >= 0f) && (_e6004 < _e691)) && (_e6001 > 0f)));
let _e6012 = (_e5879 << bitcast<u32>(_e5654));
let _e6024 = (_e5710 + 1i);
if _e5720 {
phi_15295_ = (_e5670.member - 1i);
} else {
phi_15295_ = _e5719;
}
let _e6028 = phi_15295_;
let _e6030 = select(_e6024, 0i, (_e6024 < 0i));
let _e6031 = (_e6030 >= _e5670.member_1);
if _e6031 {
phi_15306_ = (_e5670.member_1 - 1i);
} else {
phi_15306_ = _e6030;
}
let _e6034 = phi_15306_;
let _e6038 = (((f32(_e6028) + 0.5f) * _e5675) - 0.5f);
let _e6042 = (((f32(_e6034) + 0.5f) * _e5675) - 0.5f);
if _e453 {
phi_15334_ = type_23(_e6034, _e6028);
} else {
phi_15334_ = type_23(_e6028, _e6034);
}
let _e6048 = phi_15334_;
if _e5746 {
phi_15385_ = 0u;
} else {
if (_e984 == 1u) {
phi_15384_ = 0u;
} else {
if (_e984 == 2u) {
phi_15383_ = _e5067;
} else {
phi_15383_ = select(_e5073, _e5070, (_e984 == 3u));
}
let _e6056 = phi_15383_;
phi_15384_ = _e6056;
}
let _e6058 = phi_15384_;
phi_15385_ = _e6058;
}
let _e6060 = phi_15385_;
local_164 = (((bitcast<i32>(_e6060) + _e6048.member_1) * _e5064) + _e6048.member);
let _e6065 = local_164;
let _e6067 = select(_e5090, _e6065, (_e6065 < _e5090));
let _e6072 = global_6.member[bitcast<u32>(select(0i, _e6067, (_e6067 > 0i)))];
let _e6077 = (((((select(_e6038, _e6042, _e453) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e6082 = ((1f - (((select(_e6042, _e6038, _e453) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e6089 = ((_e4219.member * _e6077) + (_e4227.member * _e6082));
let _e6090 = ((_e4219.member_1 * _e6077) + (_e4227.member_1 * _e6082));
let _e6091 = ((_e4219.member_2 * _e6077) + (_e4227.member_2 * _e6082));
let _e6095 = select((_e4242.member + _e6089), _e4242.member, _e4240);
let _e6096 = select((_e4242.member_1 + _e6090), _e4242.member_1, _e4240);
let _e6097 = select((_e4242.member_2 + _e6091), _e4242.member_2, _e4240);
let _e6108 = (((_e6095 * _e6095) + (_e6096 * _e6096)) + (_e6097 * _e6097));
let _e6112 = (1f / sqrt(select(0f, _e6108, (_e6108 > 0f))));
let _e6113 = (_e6095 * _e6112);
let _e6114 = (_e6096 * _e6112);
let _e6115 = (_e6097 * _e6112);
let _e6116 = (_e575 - select(_e4253.member, (_e4253.member + _e6089), _e4240));
let _e6117 = (_e587 - select(_e4253.member_1, (_e4253.member_1 + _e6090), _e4240));
let _e6118 = (_e600 - select(_e4253.member_2, (_e4253.member_2 + _e6091), _e4240));
let _e6123 = (((_e6116 * _e6113) + (_e6117 * _e6114)) + (_e6118 * _e6115));
let _e6128 = (((_e6116 * _e613) + (_e6117 * _e626)) + (_e6118 * _e639));
let _e6133 = (((_e6113 * _e613) + (_e6114 * _e626)) + (_e6115 * _e639));
let _e6136 = ((_e6114 * _e639) - (_e6115 * _e626));
let _e6139 = ((_e6115 * _e613) - (_e6113 * _e639));
let _e6142 = ((_e6113 * _e626) - (_e6114 * _e613));
let _e6147 = (((_e6136 * _e6136) + (_e6139 * _e6139)) + (_e6142 * _e6142));
let _e6150 = (1f / select(1e-9f, _e6147, (_e6147 > 1e-9f)));
let _e6153 = ((_e6123 - (_e6133 * _e6128)) * _e6150);
let _e6156 = (((_e6133 * _e6123) - _e6128) * _e6150);
let _e6162 = select(0f, _e6153, (((_e6156 >= 0f) && (_e6156 < _e691)) && (_e6153 > 0f)));
let _e6164 = (_e6028 << bitcast<u32>(_e5654));
if _e5876 {
phi_16046_ = (_e5670.member - 1i);
} else {
phi_16046_ = _e5875;
}
let _e6179 = phi_16046_;
if _e6031 {
phi_16057_ = (_e5670.member_1 - 1i);
} else {
phi_16057_ = _e6030;
}
let _e6182 = phi_16057_;
let _e6186 = (((f32(_e6179) + 0.5f) * _e5675) - 0.5f);
let _e6190 = (((f32(_e6182) + 0.5f) * _e5675) - 0.5f);
if _e453 {
phi_16085_ = type_23(_e6182, _e6179);
} else {
phi_16085_ = type_23(_e6179, _e6182);
}
let _e6196 = phi_16085_;
if _e5746 {
phi_16136_ = 0u;
} else {
if (_e984 == 1u) {
phi_16135_ = 0u;
} else {
if (_e984 == 2u) {
phi_16134_ = _e5067;
} else {
phi_16134_ = select(_e5073, _e5070, (_e984 == 3u));
}
let _e6204 = phi_16134_;
phi_16135_ = _e6204;
}
let _e6206 = phi_16135_;
phi_16136_ = _e6206;
}
let _e6208 = phi_16136_;
local_162 = (((bitcast<i32>(_e6208) + _e6196.member_1) * _e5064) + _e6196.member);
let _e6213 = local_162;
let _e6215 = select(_e5090, _e6213, (_e6213 < _e5090));
let _e6220 = global_6.member[bitcast<u32>(select(0i, _e6215, (_e6215 > 0i)))];
let _e6225 = (((((select(_e6186, _e6190, _e453) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e6230 = ((1f - (((select(_e6190, _e6186, _e453) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e6237 = ((_e4219.member * _e6225) + (_e4227.member * _e6230));
let _e6238 = ((_e4219.member_1 * _e6225) + (_e4227.member_1 * _e6230));
let _e6239 = ((_e4219.member_2 * _e6225) + (_e4227.member_2 * _e6230));
let _e6243 = select((_e4242.member + _e6237), _e4242.member, _e4240);
let _e6244 = select((_e4242.member_1 + _e6238), _e4242.member_1, _e4240);
let _e6245 = select((_e4242.member_2 + _e6239), _e4242.member_2, _e4240);
let _e6256 = (((_e6243 * _e6243) + (_e6244 * _e6244)) + (_e6245 * _e6245));
let _e6260 = (1f / sqrt(select(0f, _e6256, (_e6256 > 0f))));
let _e6261 = (_e6243 * _e6260);
let _e6262 = (_e6244 * _e6260);
let _e6263 = (_e6245 * _e6260);
let _e6264 = (_e575 - select(_e4253.member, (_e4253.member + _e6237), _e4240));
let _e6265 = (_e587 - select(_e4253.member_1, (_e4253.member_1 + _e6238), _e4240));
let _e6266 = (_e600 - select(_e4253.member_2, (_e4253.member_2 + _e6239), _e4240));
let _e6271 = (((_e6264 * _e6261) + (_e6265 * _e6262)) + (_e6266 * _e6263));
let _e6276 = (((_e6264 * _e613) + (_e6265 * _e626)) + (_e6266 * _e639));
let _e6281 = (((_e6261 * _e613) + (_e6262 * _e626)) + (_e6263 * _e639));
let _e6284 = ((_e6262 * _e639) - (_e6263 * _e626));
let _e6287 = ((_e6263 * _e613) - (_e6261 * _e639));
let _e6290 = ((_e6261 * _e626) - (_e6262 * _e613));
let _e6295 = (((_e6284 * _e6284) + (_e6287 * _e6287)) + (_e6290 * _e6290));
let _e6298 = (1f / select(1e-9f, _e6295, (_e6295 > 1e-9f)));
let _e6301 = ((_e6271 - (_e6281 * _e6276)) * _e6298);
let _e6304 = (((_e6281 * _e6271) - _e6276) * _e6298);
let _e6310 = select(0f, _e6301, (((_e6304 >= 0f) && (_e6304 < _e691)) && (_e6301 > 0f)));
let _e6312 = (_e6179 << bitcast<u32>(_e5654));
let _e6324 = select(((((_e5653 - select(0f, (_e5715 * _e5716), (((select(select(_e766, _e923, (_e5860 >= _e692)), _e845, (_e5860 < _e298)) == _e984) && (_e5858 > 0f)) && (_e5858 < _e5768)))) - select(0f, (_e5712 * _e5716), (((select(select(_e766, _e923, (_e6012 >= _e692)), _e845, (_e6012 < _e298)) == _e984) && (_e6010 > 0f)) && (_e6010 < _e5920)))) - select(0f, (_e5715 * _e5714), (((select(select(_e766, _e923, (_e6164 >= _e692)), _e845, (_e6164 < _e298)) == _e984) && (_e6162 > 0f)) && (_e6162 < _e6072)))) - select(0f, (_e5712 * _e5714), (((select(select(_e766, _e923, (_e6312 >= _e692)), _e845, (_e6312 < _e298)) == _e984) && (_e6310 > 0f)) && (_e6310 < _e6220)))), _e5653, _e5746);
let _e6325 = (_e988 & 31u);
let _e6327 = (1u << bitcast<u32>(_e6325));
let _e6336 = bitcast<i32>((((_e927 + _e6327) - 1u) >> bitcast<u32>(_e6325)));
let _e6337 = bitcast<i32>((((_e930 + _e6327) - 1u) >> bitcast<u32>(_e6325)));
if _e453 {
phi_16815_ = type_23(_e6337, _e6336);
} else {
phi_16815_ = type_23(_e6336, _e6337);
}
let _e6341 = phi_16815_;
let _e6346 = f32((1i << bitcast<u32>(_e6325)));
let _e6347 = (1f / _e6346);
let _e6349 = ((_e4015 * _e6347) - 0.5f);
let _e6351 = ((_e4108 * _e6347) - 0.5f);
let _e6353 = select(-1f, _e6349, (_e6349 > -1f));
let _e6355 = select(1e6f, _e6353, (_e6353 < 1e6f));
let _e6362 = select(0i, select(select(i32(_e6355), i32(-2147483648), (_e6355 < -2147483600f)), 2147483647i, (_e6355 > 2147483500f)), (_e6355 == _e6355));
let _e6366 = (_e6362 - select(0i, 1i, (_e6355 < f32(_e6362))));
let _e6368 = select(-1f, _e6351, (_e6351 > -1f));
let _e6370 = select(1e6f, _e6368, (_e6368 < 1e6f));
let _e6377 = select(0i, select(select(i32(_e6370), i32(-2147483648), (_e6370 < -2147483600f)), 2147483647i, (_e6370 > 2147483500f)), (_e6370 == _e6370));
let _e6381 = (_e6377 - select(0i, 1i, (_e6370 < f32(_e6377))));
let _e6383 = (_e6349 - f32(_e6366));
let _e6385 = (_e6351 - f32(_e6381));
let _e6386 = (1f - _e6383);
let _e6387 = (1f - _e6385);
let _e6390 = select(_e6366, 0i, (_e6366 < 0i));
let _e6391 = (_e6390 >= _e6341.member);
if _e6391 {
phi_16893_ = (_e6341.member - 1i);
} else {
phi_16893_ = _e6390;
}
let _e6394 = phi_16893_;
let _e6396 = select(_e6381, 0i, (_e6381 < 0i));
let _e6397 = (_e6396 >= _e6341.member_1);
if _e6397 {
phi_16904_ = (_e6341.member_1 - 1i);
} else {
phi_16904_ = _e6396;
}
let _e6400 = phi_16904_;
let _e6404 = (((f32(_e6394) + 0.5f) * _e6346) - 0.5f);
let _e6408 = (((f32(_e6400) + 0.5f) * _e6346) - 0.5f);
if _e453 {
phi_16932_ = type_23(_e6400, _e6394);
} else {
phi_16932_ = type_23(_e6394, _e6400);
}
let _e6414 = phi_16932_;
let _e6417 = (_e988 == 0u);
if _e6417 {
phi_16983_ = 0u;
} else {
if (_e988 == 1u) {
phi_16982_ = 0u;
} else {
if (_e988 == 2u) {
phi_16981_ = _e5067;
} else {
phi_16981_ = select(_e5073, _e5070, (_e988 == 3u));
}
let _e6423 = phi_16981_;
phi_16982_ = _e6423;
}
let _e6425 = phi_16982_;
phi_16983_ = _e6425;
}
let _e6427 = phi_16983_;
local_160 = (((bitcast<i32>(_e6427) + _e6414.member_1) * _e5064) + _e6414.member);
let _e6432 = local_160;
let _e6434 = select(_e5090, _e6432, (_e6432 < _e5090));
let _e6439 = global_6.member[bitcast<u32>(select(0i, _e6434, (_e6434 > 0i)))];
let _e6444 = (((((select(_e6404, _e6408, _e453) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e6449 = ((1f - (((select(_e6408, _e6404, _e453) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e6456 = ((_e4219.member * _e6444) + (_e4227.member * _e6449));
let _e6457 = ((_e4219.member_1 * _e6444) + (_e4227.member_1 * _e6449));
let _e6458 = ((_e4219.member_2 * _e6444) + (_e4227.member_2 * _e6449));
let _e6462 = select((_e4242.member + _e6456), _e4242.member, _e4240);
let _e6463 = select((_e4242.member_1 + _e6457), _e4242.member_1, _e4240);
let _e6464 = select((_e4242.member_2 + _e6458), _e4242.member_2, _e4240);
let _e6475 = (((_e6462 * _e6462) + (_e6463 * _e6463)) + (_e6464 * _e6464));
let _e6479 = (1f / sqrt(select(0f, _e6475, (_e6475 > 0f))));
let _e6480 = (_e6462 * _e6479);
let _e6481 = (_e6463 * _e6479);
let _e6482 = (_e6464 * _e6479);
let _e6483 = (_e575 - select(_e4253.member, (_e4253.member + _e6456), _e4240));
let _e6484 = (_e587 - select(_e4253.member_1, (_e4253.member_1 + _e6457), _e4240));
let _e6485 = (_e600 - select(_e4253.member_2, (_e4253.member_2 + _e6458), _e4240));
let _e6490 = (((_e6483 * _e6480) + (_e6484 * _e6481)) + (_e6485 * _e6482));
let _e6495 = (((_e6483 * _e613) + (_e6484 * _e626)) + (_e6485 * _e639));
let _e6500 = (((_e6480 * _e613) + (_e6481 * _e626)) + (_e6482 * _e639));
let _e6503 = ((_e6481 * _e639) - (_e6482 * _e626));
let _e6506 = ((_e6482 * _e613) - (_e6480 * _e639));
let _e6509 = ((_e6480 * _e626) - (_e6481 * _e613));
let _e6514 = (((_e6503 * _e6503) + (_e6506 * _e6506)) + (_e6509 * _e6509));
let _e6517 = (1f / select(1e-9f, _e6514, (_e6514 > 1e-9f)));
let _e6520 = ((_e6490 - (_e6500 * _e6495)) * _e6517);
let _e6523 = (((_e6500 * _e6490) - _e6495) * _e6517);
let _e6529 = select(0f, _e6520, (((_e6523 >= 0f) && (_e6523 < _e691)) && (_e6520 > 0f)));
let _e6531 = (_e6394 << bitcast<u32>(_e6325));
let _e6543 = (_e6366 + 1i);
let _e6546 = select(_e6543, 0i, (_e6543 < 0i));
let _e6547 = (_e6546 >= _e6341.member);
if _e6547 {
phi_17644_ = (_e6341.member - 1i);
} else {
phi_17644_ = _e6546;
}
let _e6550 = phi_17644_;
if _e6397 {
phi_17655_ = (_e6341.member_1 - 1i);
} else {
phi_17655_ = _e6396;
}
let _e6553 = phi_17655_;
let _e6557 = (((f32(_e6550) + 0.5f) * _e6346) - 0.5f);
let _e6561 = (((f32(_e6553) + 0.5f) * _e6346) - 0.5f);
if _e453 {
phi_17683_ = type_23(_e6553, _e6550);
} else {
phi_17683_ = type_23(_e6550, _e6553);
}
let _e6567 = phi_17683_;
if _e6417 {
phi_17734_ = 0u;
} else {
if (_e988 == 1u) {
phi_17733_ = 0u;
} else {
if (_e988 == 2u) {
phi_17732_ = _e5067;
} else {
phi_17732_ = select(_e5073, _e5070, (_e988 == 3u));
}
let _e6575 = phi_17732_;
phi_17733_ = _e6575;
}
let _e6577 = phi_17733_;
phi_17734_ = _e6577;
}
let _e6579 = phi_17734_;
local_158 = (((bitcast<i32>(_e6579) + _e6567.member_1) * _e5064) + _e6567.member);
let _e6584 = local_158;
let _e6586 = select(_e5090, _e6584, (_e6584 < _e5090));
let _e6591 = global_6.member[bitcast<u32>(select(0i, _e6586, (_e6586 > 0i)))];
let _e6596 = (((((select(_e6557, _e6561, _e453) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e6601 = ((1f - (((select(_e6561, _e6557, _e453) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e6608 = ((_e4219.member * _e6596) + (_e4227.member * _e6601));
let _e6609 = ((_e4219.member_1 * _e6596) + (_e4227.member_1 * _e6601));
let _e6610 = ((_e4219.member_2 * _e6596) + (_e4227.member_2 * _e6601));
let _e6614 = select((_e4242.member + _e6608), _e4242.member, _e4240);
let _e6615 = select((_e4242.member_1 + _e6609), _e4242.member_1, _e4240);
let _e6616 = select((_e4242.member_2 + _e6610), _e4242.member_2, _e4240);
let _e6627 = (((_e6614 * _e6614) + (_e6615 * _e6615)) + (_e6616 * _e6616));
let _e6631 = (1f / sqrt(select(0f, _e6627, (_e6627 > 0f))));
let _e6632 = (_e6614 * _e6631);
let _e6633 = (_e6615 * _e6631);
let _e6634 = (_e6616 * _e6631);
let _e6635 = (_e575 - select(_e4253.member, (_e4253.member + _e6608), _e4240));
let _e6636 = (_e587 - select(_e4253.member_1, (_e4253.member_1 + _e6609), _e4240));
let _e6637 = (_e600 - select(_e4253.member_2, (_e4253.member_2 + _e6610), _e4240));
let _e6642 = (((_e6635 * _e6632) + (_e6636 * _e6633)) + (_e6637 * _e6634));
let _e6647 = (((_e6635 * _e613) + (_e6636 * _e626)) + (_e6637 * _e639));
let _e6652 = (((_e6632 * _e613) + (_e6633 * _e626)) + (_e6634 * _e639));
let _e6655 = ((_e6633 * _e639) - (_e6634 * _e626));
let _e6658 = ((_e6634 * _e613) - (_e6632 * _e639));
let _e6661 = ((_e6632 * _e626) - (_e6633 * _e613));
let _e6666 = (((_e6655 * _e6655) + (_e6658 * _e6658)) + (_e6661 * _e6661));
let _e6669 = (1f / select(1e-9f, _e6666, (_e6666 > 1e-9f)));
let _e6672 = ((_e6642 - (_e6652 * _e6647)) * _e6669);
let _e6675 = (((_e6652 * _e6642) - _e6647) * _e6669);
let _e6681 = select(0f, _e6672, (((_e6675 >= 0f) && (_e6675 < _e691)) && (_e6672 > 0f)));
let _e6683 = (_e6550 << bitcast<u32>(_e6325));
let _e6695 = (_e6381 + 1i);
if _e6391 {
phi_18395_ = (_e6341.member - 1i);
} else {
phi_18395_ = _e6390;
}
let _e6699 = phi_18395_;
let _e6701 = select(_e6695, 0i, (_e6695 < 0i));
let _e6702 = (_e6701 >= _e6341.member_1);
if _e6702 {
phi_18406_ = (_e6341.member_1 - 1i);
} else {
phi_18406_ = _e6701;
}
let _e6705 = phi_18406_;
let _e6709 = (((f32(_e6699) + 0.5f) * _e6346) - 0.5f);
let _e6713 = (((f32(_e6705) + 0.5f) * _e6346) - 0.5f);
if _e453 {
phi_18434_ = type_23(_e6705, _e6699);
} else {
phi_18434_ = type_23(_e6699, _e6705);
}
let _e6719 = phi_18434_;
if _e6417 {
phi_18485_ = 0u;
} else {
if (_e988 == 1u) {
phi_18484_ = 0u;
} else {
if (_e988 == 2u) {
phi_18483_ = _e5067;
} else {
phi_18483_ = select(_e5073, _e5070, (_e988 == 3u));
}
let _e6727 = phi_18483_;
phi_18484_ = _e6727;
}
let _e6729 = phi_18484_;
phi_18485_ = _e6729;
}
let _e6731 = phi_18485_;
local_156 = (((bitcast<i32>(_e6731) + _e6719.member_1) * _e5064) + _e6719.member);
let _e6736 = local_156;
let _e6738 = select(_e5090, _e6736, (_e6736 < _e5090));
let _e6743 = global_6.member[bitcast<u32>(select(0i, _e6738, (_e6738 > 0i)))];
let _e6748 = (((((select(_e6709, _e6713, _e453) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e6753 = ((1f - (((select(_e6713, _e6709, _e453) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e6760 = ((_e4219.member * _e6748) + (_e4227.member * _e6753));
let _e6761 = ((_e4219.member_1 * _e6748) + (_e4227.member_1 * _e6753));
let _e6762 = ((_e4219.member_2 * _e6748) + (_e4227.member_2 * _e6753));
let _e6766 = select((_e4242.member + _e6760), _e4242.member, _e4240);
let _e6767 = select((_e4242.member_1 + _e6761), _e4242.member_1, _e4240);
let _e6768 = select((_e4242.member_2 + _e6762), _e4242.member_2, _e4240);
let _e6779 = (((_e6766 * _e6766) + (_e6767 * _e6767)) + (_e6768 * _e6768));
let _e6783 = (1f / sqrt(select(0f, _e6779, (_e6779 > 0f))));
let _e6784 = (_e6766 * _e6783);
let _e6785 = (_e6767 * _e6783);
let _e6786 = (_e6768 * _e6783);
let _e6787 = (_e575 - select(_e4253.member, (_e4253.member + _e6760), _e4240));
let _e6788 = (_e587 - select(_e4253.member_1, (_e4253.member_1 + _e6761), _e4240));
let _e6789 = (_e600 - select(_e4253.member_2, (_e4253.member_2 + _e6762), _e4240));
let _e6794 = (((_e6787 * _e6784) + (_e6788 * _e6785)) + (_e6789 * _e6786));
let _e6799 = (((_e6787 * _e613) + (_e6788 * _e626)) + (_e6789 * _e639));
let _e6804 = (((_e6784 * _e613) + (_e6785 * _e626)) + (_e6786 * _e639));
let _e6807 = ((_e6785 * _e639) - (_e6786 * _e626));
let _e6810 = ((_e6786 * _e613) - (_e6784 * _e639));
let _e6813 = ((_e6784 * _e626) - (_e6785 * _e613));
let _e6818 = (((_e6807 * _e6807) + (_e6810 * _e6810)) + (_e6813 * _e6813));
let _e6821 = (1f / select(1e-9f, _e6818, (_e6818 > 1e-9f)));
let _e6824 = ((_e6794 - (_e6804 * _e6799)) * _e6821);
let _e6827 = (((_e6804 * _e6794) - _e6799) * _e6821);
let _e6833 = select(0f, _e6824, (((_e6827 >= 0f) && (_e6827 < _e691)) && (_e6824 > 0f)));
let _e6835 = (_e6699 << bitcast<u32>(_e6325));
if _e6547 {
phi_19146_ = (_e6341.member - 1i);
} else {
phi_19146_ = _e6546;
}
let _e6850 = phi_19146_;
if _e6702 {
phi_19157_ = (_e6341.member_1 - 1i);
} else {
phi_19157_ = _e6701;
}
let _e6853 = phi_19157_;
let _e6857 = (((f32(_e6850) + 0.5f) * _e6346) - 0.5f);
let _e6861 = (((f32(_e6853) + 0.5f) * _e6346) - 0.5f);
if _e453 {
phi_19185_ = type_23(_e6853, _e6850);
} else {
phi_19185_ = type_23(_e6850, _e6853);
}
let _e6867 = phi_19185_;
if _e6417 {
phi_19236_ = 0u;
} else {
if (_e988 == 1u) {
phi_19235_ = 0u;
} else {
if (_e988 == 2u) {
phi_19234_ = _e5067;
} else {
phi_19234_ = select(_e5073, _e5070, (_e988 == 3u));
}
let _e6875 = phi_19234_;
phi_19235_ = _e6875;
}
let _e6877 = phi_19235_;
phi_19236_ = _e6877;
}
let _e6879 = phi_19236_;
local_154 = (((bitcast<i32>(_e6879) + _e6867.member_1) * _e5064) + _e6867.member);
let _e6884 = local_154;
let _e6886 = select(_e5090, _e6884, (_e6884 < _e5090));
let _e6891 = global_6.member[bitcast<u32>(select(0i, _e6886, (_e6886 > 0i)))];
let _e6896 = (((((select(_e6857, _e6861, _e453) + 0.5f) / _e4200) * 2f) - 1f) * _e4208);
let _e6901 = ((1f - (((select(_e6861, _e6857, _e453) + 0.5f) / _e4201) * 2f)) * _e4216);
let _e6908 = ((_e4219.member * _e6896) + (_e4227.member * _e6901));
let _e6909 = ((_e4219.member_1 * _e6896) + (_e4227.member_1 * _e6901));
let _e6910 = ((_e4219.member_2 * _e6896) + (_e4227.member_2 * _e6901));
let _e6914 = select((_e4242.member + _e6908), _e4242.member, _e4240);
let _e6915 = select((_e4242.member_1 + _e6909), _e4242.member_1, _e4240);
let _e6916 = select((_e4242.member_2 + _e6910), _e4242.member_2, _e4240);
let _e6927 = (((_e6914 * _e6914) + (_e6915 * _e6915)) + (_e6916 * _e6916));
let _e6931 = (1f / sqrt(select(0f, _e6927, (_e6927 > 0f))));
let _e6932 = (_e6914 * _e6931);
let _e6933 = (_e6915 * _e6931);
let _e6934 = (_e6916 * _e6931);
let _e6935 = (_e575 - select(_e4253.member, (_e4253.member + _e6908), _e4240));
let _e6936 = (_e587 - select(_e4253.member_1, (_e4253.member_1 + _e6909), _e4240));
let _e6937 = (_e600 - select(_e4253.member_2, (_e4253.member_2 + _e6910), _e4240));
let _e6942 = (((_e6935 * _e6932) + (_e6936 * _e6933)) + (_e6937 * _e6934));
let _e6947 = (((_e6935 * _e613) + (_e6936 * _e626)) + (_e6937 * _e639));
let _e6952 = (((_e6932 * _e613) + (_e6933 * _e626)) + (_e6934 * _e639));
let _e6955 = ((_e6933 * _e639) - (_e6934 * _e626));
let _e6958 = ((_e6934 * _e613) - (_e6932 * _e639));
let _e6961 = ((_e6932 * _e626) - (_e6933 * _e613));
let _e6966 = (((_e6955 * _e6955) + (_e6958 * _e6958)) + (_e6961 * _e6961));
let _e6969 = (1f / select(1e-9f, _e6966, (_e6966 > 1e-9f)));
let _e6972 = ((_e6942 - (_e6952 * _e6947)) * _e6969);
let _e6975 = (((_e6952 * _e6942) - _e6947) * _e6969);
let _e6981 = select(0f, _e6972, (((_e6975 >= 0f) && (_e6975 < _e691)) && (_e6972 > 0f)));
let _e6983 = (_e6850 << bitcast<u32>(_e6325));
let _e6995 = select(((((_e6324 - select(0f, (_e6386 * _e6387), (((select(select(_e766, _e923, (_e6531 >= _e692)), _e845, (_e6531 < _e298)) == _e988) && (_e6529 > 0f)) && (_e6529 < _e6439)))) - select(0f, (_e6383 * _e6387), (((select(select(_e766, _e923, (_e6683 >= _e692)), _e845, (_e6683 < _e298)) == _e988) && (_e6681 > 0f)) && (_e6681 < _e6591)))) - select(0f, (_e6386 * _e6385), (((select(select(_e766, _e923, (_e6835 >= _e692)), _e845, (_e6835 < _e298)) == _e988) && (_e6833 > 0f)) && (_e6833 < _e6743)))) - select(0f, (_e6383 * _e6385), (((select(select(_e766, _e923, (_e6983 >= _e692)), _e845, (_e6983 < _e298)) == _e988) && (_e6981 > 0f)) && (_e6981 < _e6891)))), _e6324, _e6417);
if _e453 {
phi_19906_ = type_23(_e4105, _e4013);
} else {
phi_19906_ = type_23(_e4013, _e4105);
}
let _e7010 = phi_19906_;
let _e7013 = (_e4106 && (((_e4968 > 0f) && (_e4968 < _e4196)) && (bitcast<f32>((bitcast<u32>(_e6995) & 2147483647u)) > 1e-6f)));
let _e7016 = global_1.member.member_18.member;
let _e7017 = (((select(_e4131, (1f - _e4131), (_e4116 >= 0f)) - select(_e4150, (1f - _e4150), (_e4135 >= 0f))) * (1f / _e4113)) * _e7016);
let _e7021 = select(0f, (((((_e652 * _e4805.member) * ((1f + (_e4845 * (1f + (_e4845 * (0.5f + (_e4845 * (0.16666667f + (_e4845 * (0.041666668f + (_e4845 * (0.008333334f + (_e4845 * (0.001388889f + (_e4845 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4840 + 127i)) << bitcast<u32>(23i))))) * _e4802) * _e6995) * _e7017), _e7013);
let _e7022 = select(0f, (((((_e665 * _e4805.member_1) * ((1f + (_e4893 * (1f + (_e4893 * (0.5f + (_e4893 * (0.16666667f + (_e4893 * (0.041666668f + (_e4893 * (0.008333334f + (_e4893 * (0.001388889f + (_e4893 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4888 + 127i)) << bitcast<u32>(23i))))) * _e4802) * _e6995) * _e7017), _e7013);
let _e7023 = select(0f, (((((_e678 * _e4805.member_2) * ((1f + (_e4941 * (1f + (_e4941 * (0.5f + (_e4941 * (0.16666667f + (_e4941 * (0.041666668f + (_e4941 * (0.008333334f + (_e4941 * (0.001388889f + (_e4941 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4936 + 127i)) << bitcast<u32>(23i))))) * _e4802) * _e6995) * _e7017), _e7013);
let _e7027 = (bitcast<f32>((bitcast<u32>(_e7021) & 2147483647u)) >= 1073741800f);
let _e7028 = (1f / 1048576f);
let _e7031 = ((_e7021 * select(1f, _e7028, _e7027)) + 0.5f);
let _e7033 = select(-1073741800f, _e7031, (_e7031 > -1073741800f));
let _e7035 = select(1073741800f, _e7033, (_e7033 < 1073741800f));
let _e7042 = select(0i, select(select(i32(_e7035), i32(-2147483648), (_e7035 < -2147483600f)), 2147483647i, (_e7035 > 2147483500f)), (_e7035 == _e7035));
let _e7046 = (_e7042 - select(0i, 1i, (_e7035 < f32(_e7042))));
let _e7047 = select(0i, 20i, _e7027);
let _e7051 = (bitcast<u32>(_e7046) << bitcast<u32>((_e7047 & 31i)));
let _e7058 = bitcast<u32>(((_e7046 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e7047) & 31i))));
let _e7062 = (bitcast<f32>((bitcast<u32>(_e7022) & 2147483647u)) >= 1073741800f);
let _e7065 = ((_e7022 * select(1f, _e7028, _e7062)) + 0.5f);
let _e7067 = select(-1073741800f, _e7065, (_e7065 > -1073741800f));
let _e7069 = select(1073741800f, _e7067, (_e7067 < 1073741800f));
let _e7076 = select(0i, select(select(i32(_e7069), i32(-2147483648), (_e7069 < -2147483600f)), 2147483647i, (_e7069 > 2147483500f)), (_e7069 == _e7069));
let _e7080 = (_e7076 - select(0i, 1i, (_e7069 < f32(_e7076))));
let _e7081 = select(0i, 20i, _e7062);
let _e7085 = (bitcast<u32>(_e7080) << bitcast<u32>((_e7081 & 31i)));
let _e7092 = bitcast<u32>(((_e7080 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e7081) & 31i))));
let _e7096 = (bitcast<f32>((bitcast<u32>(_e7023) & 2147483647u)) >= 1073741800f);
let _e7099 = ((_e7023 * select(1f, _e7028, _e7096)) + 0.5f);
let _e7101 = select(-1073741800f, _e7099, (_e7099 > -1073741800f));
let _e7103 = select(1073741800f, _e7101, (_e7101 < 1073741800f));
let _e7110 = select(0i, select(select(i32(_e7103), i32(-2147483648), (_e7103 < -2147483600f)), 2147483647i, (_e7103 > 2147483500f)), (_e7103 == _e7103));
let _e7114 = (_e7110 - select(0i, 1i, (_e7103 < f32(_e7110))));
let _e7115 = select(0i, 20i, _e7096);
let _e7119 = (bitcast<u32>(_e7114) << bitcast<u32>((_e7115 & 31i)));
let _e7126 = bitcast<u32>(((_e7114 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e7115) & 31i))));
let _e7131 = bitcast<i32>(bitcast<u32>((((_e7010.member_1 * _e931) + _e7010.member) * 6i)));
if ((_e7051 | _e7058) == 0u) {
} else {
let _e7134 = bitcast<u32>(_e7131);
if (_e7134 < _e270) {
let _e7138 = atomicAdd((&global_8.member[_e7134]), _e7051);
phi_20139_ = _e7138;
} else {
phi_20139_ = 0u;
}
let _e7140 = phi_20139_;
let _e7144 = (_e7058 + select(0u, 1u, ((_e7140 + _e7051) < _e7051)));
if (_e7144 == 0u) {
} else {
let _e7146 = (_e7134 + 1u);
if (_e7146 < _e270) {
let _e7150 = atomicAdd((&global_8.member[_e7146]), _e7144);
}
}
}
if ((_e7085 | _e7092) == 0u) {
} else {
let _e7154 = bitcast<u32>((_e7131 + 2i));
if (_e7154 < _e270) {
let _e7158 = atomicAdd((&global_8.member[_e7154]), _e7085);
phi_20169_ = _e7158;
} else {
phi_20169_ = 0u;
}
let _e7160 = phi_20169_;
let _e7164 = (_e7092 + select(0u, 1u, ((_e7160 + _e7085) < _e7085)));
if (_e7164 == 0u) {
} else {
let _e7166 = (_e7154 + 1u);
if (_e7166 < _e270) {
let _e7170 = atomicAdd((&global_8.member[_e7166]), _e7164);
}
}
}
if ((_e7119 | _e7126) == 0u) {
} else {
let _e7174 = bitcast<u32>((_e7131 + 4i));
if (_e7174 < _e270) {
let _e7178 = atomicAdd((&global_8.member[_e7174]), _e7119);
phi_20199_ = _e7178;
} else {
phi_20199_ = 0u;
}
let _e7180 = phi_20199_;
let _e7184 = (_e7126 + select(0u, 1u, ((_e7180 + _e7119) < _e7119)));
if (_e7184 == 0u) {
} else {
let _e7186 = (_e7174 + 1u);
if (_e7186 < _e270) {
let _e7190 = atomicAdd((&global_8.member[_e7186]), _e7184);
}
}
}
phi_9217_ = (_e4103 + 1i);
} else {
phi_9217_ = i32();
}
let _e7193 = phi_9217_;
continue;
continuing {
phi_9216_ = _e7193;
break if !(_e4106);
}
}
phi_9063_ = (_e4010 + 1i);
} else {
phi_9063_ = i32();
}
let _e7197 = phi_9063_;
continue;
continuing {
phi_9062_ = _e7197;
break if !(_e4011);
}
}
}
}
} else {
let _e7199 = (_e766 & 31u);
let _e7201 = (1u << bitcast<u32>(_e7199));
let _e7210 = bitcast<i32>((((_e927 + _e7201) - 1u) >> bitcast<u32>(_e7199)));
let _e7211 = bitcast<i32>((((_e930 + _e7201) - 1u) >> bitcast<u32>(_e7199)));
if _e453 {
phi_20265_ = type_23(_e7211, _e7210);
} else {
phi_20265_ = type_23(_e7210, _e7211);
}
let _e7215 = phi_20265_;
let _e7219 = (_e957 >> bitcast<u32>(_e7199));
if (_e7219 < _e7215.member) {
phi_20340_ = _e7219;
} else {
phi_20340_ = (_e7215.member - 1i);
}
let _e7225 = phi_20340_;
phi_20344_ = type_23(2147483647i, -1i);
phi_20347_ = 0i;
loop {
let _e7228 = phi_20344_;
let _e7230 = phi_20347_;
local_231 = _e7228;
local_232 = _e7228;
let _e7231 = (_e7230 < 16i);
if _e7231 {
let _e7233 = (1i << bitcast<u32>(_e7199));
let _e7234 = f32(_e7233);
let _e7236 = ((4u - _e766) & 31u);
let _e7241 = ((_e975 >> bitcast<u32>(_e7199)) + (_e7230 & ((1i << bitcast<u32>(_e7236)) - 1i)));
let _e7245 = (((f32(_e7241) + 0.5f) * _e7234) - 0.5f);
let _e7249 = (-(((_e416 * _e7245) + _e442)) / _e429);
let _e7256 = bitcast<f32>((bitcast<u32>(((_e466 * _e7245) + ((_e479 * _e7249) + _e492))) & 2147483647u));
let _e7263 = bitcast<f32>((bitcast<u32>(((_e505 * _e7245) + ((_e518 * _e7249) + _e531))) & 2147483647u));
let _e7268 = (((0.5f * (_e7256 + _e7263)) / _e534) + (0.5f * _e7234));
let _e7269 = (1f / _e7234);
let _e7277 = ((((_e7249 + _e7268) + 0.5f) * _e7269) - 0.5f);
let _e7278 = f32((_e7215.member_1 - 1i));
let _e7279 = (0f - 1f);
let _e7281 = select(_e7279, _e7277, (_e7277 > _e7279));
let _e7283 = select(_e7278, _e7281, (_e7281 < _e7278));
let _e7290 = select(0i, select(select(i32(_e7283), i32(-2147483648), (_e7283 < -2147483600f)), 2147483647i, (_e7283 > 2147483500f)), (_e7283 == _e7283));
let _e7295 = (((((_e7249 - _e7268) + 0.5f) * _e7269) - 0.5f) + 1f);
let _e7296 = (_e7278 + 1f);
let _e7298 = select(0f, _e7295, (_e7295 > 0f));
let _e7300 = select(_e7296, _e7298, (_e7298 < _e7296));
let _e7307 = select(0i, select(select(i32(_e7300), i32(-2147483648), (_e7300 < -2147483600f)), 2147483647i, (_e7300 > 2147483500f)), (_e7300 == _e7300));
let _e7318 = ((1e-4f * _e7234) * _e534);
let _e7320 = select(_e7263, _e7256, (_e7256 > _e7263));
let _e7322 = select(_e7318, _e7320, (_e7320 > _e7318));
let _e7324 = select(_e7263, _e7256, (_e7256 < _e7263));
let _e7326 = select(_e7318, _e7324, (_e7324 > _e7318));
let _e7328 = (0.5f * (_e7322 + _e7326));
let _e7329 = (0.5f / _e7326);
let _e7330 = (1f / _e7322);
phi_20498_ = _e7228;
phi_20501_ = 0i;
loop {
let _e7332 = phi_20498_;
let _e7334 = phi_20501_;
local_241 = _e7332;
let _e7337 = (((_e7307 - select(0i, 1i, (_e7300 < f32(_e7307)))) + (_e7230 >> bitcast<u32>(_e7236))) + (_e7334 << bitcast<u32>(_e7199)));
let _e7338 = (_e7337 <= select(-1i, (_e7290 - select(0i, 1i, (_e7283 < f32(_e7290)))), (_e7241 <= _e7225)));
if _e7338 {
let _e7342 = (((f32(_e7337) + 0.5f) * _e7234) - 0.5f);
let _e7344 = ((_e7342 - _e7249) * _e534);
let _e7345 = (_e534 * _e7234);
let _e7347 = (0.5f * _e7345);
let _e7348 = (_e7344 + _e7347);
let _e7349 = -(_e7348);
let _e7352 = (_e7328 - select(_e7349, _e7348, (_e7348 > _e7349)));
let _e7354 = select(0f, _e7352, (_e7352 > 0f));
let _e7356 = select(_e7326, _e7354, (_e7354 < _e7326));
let _e7359 = (_e7352 - _e7326);
let _e7363 = (((_e7356 * (_e7356 * _e7329)) + select(0f, _e7359, (_e7359 > 0f))) * _e7330);
let _e7367 = (_e7344 - _e7347);
let _e7368 = -(_e7367);
let _e7371 = (_e7328 - select(_e7368, _e7367, (_e7367 > _e7368)));
let _e7373 = select(0f, _e7371, (_e7371 > 0f));
let _e7375 = select(_e7326, _e7373, (_e7373 < _e7326));
let _e7378 = (_e7371 - _e7326);
let _e7382 = (((_e7375 * (_e7375 * _e7329)) + select(0f, _e7378, (_e7378 > 0f))) * _e7330);
if _e453 {
phi_20631_ = type_23(_e7337, _e7241);
} else {
phi_20631_ = type_23(_e7241, _e7337);
}
let _e7393 = phi_20631_;
let _e7399 = bitcast<i32>(((_e927 + 1u) >> bitcast<u32>(1u)));
let _e7402 = global_1.member.member_18.member_9;
let _e7407 = global_1.member.member_18.member_6;
let _e7410 = global_1.member.member_18.member_7;
let _e7413 = global_1.member.member_18.member_8;
if _e982 {
phi_20682_ = 0u;
} else {
if (_e766 == 1u) {
phi_20681_ = 0u;
} else {
if (_e766 == 2u) {
phi_20680_ = _e7407;
} else {
phi_20680_ = select(_e7413, _e7410, (_e766 == 3u));
}
let _e7419 = phi_20680_;
phi_20681_ = _e7419;
}
let _e7421 = phi_20681_;
phi_20682_ = _e7421;
}
let _e7423 = phi_20682_;
local_152 = (((bitcast<i32>(_e7423) + _e7393.member_1) * _e7399) + _e7393.member);
local_153 = (_e7399 * bitcast<i32>(_e7402));
let _e7428 = local_152;
let _e7430 = (bitcast<i32>(_e262) - 1i);
let _e7432 = select(_e7430, _e7428, (_e7428 < _e7430));
let _e7437 = global_6.member[bitcast<u32>(select(0i, _e7432, (_e7432 > 0i)))];
let _e7438 = local_153;
let _e7439 = local_152;
let _e7440 = (_e7438 + _e7439);
let _e7442 = select(_e7430, _e7440, (_e7440 < _e7430));
let _e7447 = global_6.member[bitcast<u32>(select(0i, _e7442, (_e7442 > 0i)))];
let _e7448 = local_153;
let _e7450 = local_152;
let _e7451 = ((2i * _e7448) + _e7450);
let _e7453 = select(_e7430, _e7451, (_e7451 < _e7430));
let _e7458 = global_6.member[bitcast<u32>(select(0i, _e7453, (_e7453 > 0i)))];
let _e7460 = (_e7233 >> bitcast<u32>(1i));
let _e7463 = ((_e7393.member << bitcast<u32>(_e7199)) + _e7460);
let _e7466 = ((_e7393.member_1 << bitcast<u32>(_e7199)) + _e7460);
let _e7468 = select(_e7463, 0i, (_e7463 < 0i));
if (_e7468 >= _e931) {
phi_20808_ = (_e931 - 1i);
} else {
phi_20808_ = _e7468;
}
let _e7472 = phi_20808_;
let _e7474 = select(_e7466, 0i, (_e7466 < 0i));
if (_e7474 >= _e932) {
phi_20819_ = (_e932 - 1i);
} else {
phi_20819_ = _e7474;
}
let _e7478 = phi_20819_;
let _e7480 = bitcast<i32>((_e927 * _e930));
local_150 = _e7480;
local_151 = ((_e7478 * _e931) + _e7472);
let _e7483 = local_150;
let _e7484 = local_151;
let _e7485 = (_e7483 + _e7484);
let _e7487 = (bitcast<i32>(_e259) - 1i);
let _e7489 = select(_e7487, _e7485, (_e7485 < _e7487));
let _e7494 = global_5.member[bitcast<u32>(select(0i, _e7489, (_e7489 > 0i)))];
let _e7495 = local_150;
let _e7497 = local_151;
let _e7498 = ((2i * _e7495) + _e7497);
let _e7500 = select(_e7487, _e7498, (_e7498 < _e7487));
let _e7505 = global_5.member[bitcast<u32>(select(0i, _e7500, (_e7500 > 0i)))];
let _e7506 = local_151;
let _e7515 = global_1.member.member_2.member;
let _e7516 = (((((select(_e7245, _e7342, _e453) + 0.5f) / f32(_e931)) * 2f) - 1f) * _e7515);
let _e7523 = global_1.member.member_2.member_1;
let _e7524 = ((1f - (((select(_e7342, _e7245, _e453) + 0.5f) / f32(_e932)) * 2f)) * _e7523);
let _e7526 = global_1.member.member_3;
let _e7534 = global_1.member.member_4;
let _e7541 = ((_e7526.member * _e7516) + (_e7534.member * _e7524));
let _e7542 = ((_e7526.member_1 * _e7516) + (_e7534.member_1 * _e7524));
let _e7543 = ((_e7526.member_2 * _e7516) + (_e7534.member_2 * _e7524));
let _e7546 = global_1.member.member_2.member_3;
let _e7547 = (_e7546 != 0u);
let _e7549 = global_1.member.member_5;
let _e7556 = select((_e7549.member + _e7541), _e7549.member, _e7547);
let _e7557 = select((_e7549.member_1 + _e7542), _e7549.member_1, _e7547);
let _e7558 = select((_e7549.member_2 + _e7543), _e7549.member_2, _e7547);
let _e7560 = global_1.member.member_6;
let _e7567 = select(_e7560.member, (_e7560.member + _e7541), _e7547);
let _e7568 = select(_e7560.member_1, (_e7560.member_1 + _e7542), _e7547);
let _e7569 = select(_e7560.member_2, (_e7560.member_2 + _e7543), _e7547);
let _e7574 = (((_e7556 * _e7556) + (_e7557 * _e7557)) + (_e7558 * _e7558));
let _e7577 = sqrt(select(0f, _e7574, (_e7574 > 0f)));
let _e7578 = (1f / _e7577);
let _e7579 = (_e7556 * _e7578);
let _e7580 = (_e7557 * _e7578);
let _e7581 = (_e7558 * _e7578);
let _e7582 = (_e575 - _e7567);
let _e7583 = (_e587 - _e7568);
let _e7584 = (_e600 - _e7569);
let _e7589 = (((_e7582 * _e7579) + (_e7583 * _e7580)) + (_e7584 * _e7581));
let _e7594 = (((_e7582 * _e613) + (_e7583 * _e626)) + (_e7584 * _e639));
let _e7599 = (((_e7579 * _e613) + (_e7580 * _e626)) + (_e7581 * _e639));
let _e7602 = ((_e7580 * _e639) - (_e7581 * _e626));
let _e7605 = ((_e7581 * _e613) - (_e7579 * _e639));
let _e7608 = ((_e7579 * _e626) - (_e7580 * _e613));
let _e7613 = (((_e7602 * _e7602) + (_e7605 * _e7605)) + (_e7608 * _e7608));
let _e7616 = (1f / select(1e-9f, _e7613, (_e7613 > 1e-9f)));
let _e7619 = ((_e7589 - (_e7599 * _e7594)) * _e7616);
let _e7622 = (((_e7599 * _e7589) - _e7594) * _e7616);
let _e7628 = -(_e7599);
let _e7631 = global_1.member.member_13.member_2;
let _e7632 = (_e7631 * _e7631);
let _e7636 = ((1f + _e7632) - ((2f * _e7631) * _e7628));
let _e7638 = select(1e-9f, _e7636, (_e7636 > 1e-9f));
let _e7650 = global_1.member.member_13.member_3;
if (_e7650 == 2u) {
let _e7655 = (0.5f - (0.5f * _e7628));
let _e7657 = select(0f, _e7655, (_e7655 > 0f));
let _e7661 = (sqrt(select(0f, _e7657, (_e7657 > 0f))) * 255f);
let _e7662 = (255f - 1f);
let _e7664 = select(0f, _e7661, (_e7661 > 0f));
let _e7666 = select(_e7662, _e7664, (_e7664 < _e7662));
let _e7673 = select(0i, select(select(i32(_e7666), i32(-2147483648), (_e7666 < -2147483600f)), 2147483647i, (_e7666 > 2147483500f)), (_e7666 == _e7666));
let _e7677 = (_e7673 - select(0i, 1i, (_e7666 < f32(_e7673))));
let _e7680 = global_1.member.member_13.member_11;
let _e7681 = bitcast<i32>(_e7680);
let _e7682 = (_e7681 + _e7677);
let _e7684 = (bitcast<i32>(_e265) - 1i);
let _e7686 = select(_e7684, _e7682, (_e7682 < _e7684));
let _e7691 = global_2.member[bitcast<u32>(select(0i, _e7686, (_e7686 > 0i)))];
let _e7693 = (_e7681 + (_e7677 + 1i));
let _e7695 = select(_e7684, _e7693, (_e7693 < _e7684));
let _e7700 = global_2.member[bitcast<u32>(select(0i, _e7695, (_e7695 > 0i)))];
phi_21242_ = (_e7691 + ((_e7700 - _e7691) * (_e7661 - f32(_e7677))));
} else {
phi_21242_ = select(((1f - _e7632) / (_e7638 * sqrt(select(0f, _e7638, (_e7638 > 0f))))), (0.75f * (1f + (_e7628 * _e7628))), (_e7650 == 1u));
}
let _e7707 = phi_21242_;
let _e7713 = global_1.member.member_12.member_12;
let _e7716 = global_1.member.member_12.member_4;
let _e7719 = global_1.member.member_12.member_13;
let _e7725 = global_1.member.member.member;
let _e7727 = (_e7622 / _e691);
local_147 = bitcast<i32>((_e7713 + (_e7716 * _e7719)));
local_148 = _e281;
local_149 = bitcast<i32>(_e7725);
let _e7730 = global_1.member.member_13.member_6;
let _e7731 = f32(_e7730);
let _e7733 = select(0f, _e7727, (_e7727 > 0f));
let _e7736 = (select(1f, _e7733, (_e7733 < 1f)) * _e7731);
let _e7737 = (_e7731 - 1f);
let _e7739 = select(0f, _e7737, (_e7737 > 0f));
let _e7741 = select(0f, _e7736, (_e7736 > 0f));
let _e7743 = select(_e7739, _e7741, (_e7741 < _e7739));
let _e7750 = select(0i, select(select(i32(_e7743), i32(-2147483648), (_e7743 < -2147483600f)), 2147483647i, (_e7743 > 2147483500f)), (_e7743 == _e7743));
let _e7754 = (_e7750 - select(0i, 1i, (_e7743 < f32(_e7750))));
if (_e7754 > 0i) {
let _e7757 = local_147;
let _e7758 = local_149;
let _e7761 = local_148;
let _e7762 = ((_e7757 + ((_e7754 - 1i) * _e7758)) + _e7761);
let _e7764 = (bitcast<i32>(_e268) - 1i);
let _e7766 = select(_e7764, _e7762, (_e7762 < _e7764));
let _e7771 = global_7.member[bitcast<u32>(select(0i, _e7766, (_e7766 > 0i)))];
phi_21348_ = _e7771;
} else {
phi_21348_ = 0f;
}
let _e7773 = phi_21348_;
let _e7774 = local_147;
let _e7775 = local_149;
let _e7778 = local_148;
let _e7779 = ((_e7774 + (_e7754 * _e7775)) + _e7778);
let _e7781 = (bitcast<i32>(_e268) - 1i);
let _e7783 = select(_e7781, _e7779, (_e7779 < _e7781));
let _e7788 = global_7.member[bitcast<u32>(select(0i, _e7783, (_e7783 > 0i)))];
let _e7795 = (_e7505 - _e7494);
let _e7798 = ((_e7619 - _e7494) / select(1e-9f, _e7795, (_e7795 > 1e-9f)));
local_144 = 0i;
local_145 = _e7506;
local_146 = _e7480;
let _e7800 = select(0f, _e7798, (_e7798 > 0f));
let _e7803 = (select(1f, _e7800, (_e7800 < 1f)) * _e7731);
let _e7805 = select(0f, _e7803, (_e7803 > 0f));
let _e7807 = select(_e7739, _e7805, (_e7805 < _e7739));
let _e7814 = select(0i, select(select(i32(_e7807), i32(-2147483648), (_e7807 < -2147483600f)), 2147483647i, (_e7807 > 2147483500f)), (_e7807 == _e7807));
let _e7818 = (_e7814 - select(0i, 1i, (_e7807 < f32(_e7814))));
if (_e7818 > 0i) {
let _e7821 = local_144;
let _e7822 = local_146;
let _e7825 = local_145;
let _e7826 = ((_e7821 + ((_e7818 - 1i) * _e7822)) + _e7825);
let _e7828 = select(_e7781, _e7826, (_e7826 < _e7781));
let _e7833 = global_7.member[bitcast<u32>(select(0i, _e7828, (_e7828 > 0i)))];
phi_21475_ = _e7833;
} else {
phi_21475_ = 0f;
}
let _e7835 = phi_21475_;
let _e7836 = local_144;
let _e7837 = local_146;
let _e7840 = local_145;
let _e7841 = ((_e7836 + (_e7818 * _e7837)) + _e7840);
let _e7843 = select(_e7781, _e7841, (_e7841 < _e7781));
let _e7848 = global_7.member[bitcast<u32>(select(0i, _e7843, (_e7843 > 0i)))];
let _e7854 = ((_e7773 + ((_e7788 - _e7773) * (_e7736 - f32(_e7754)))) + (_e7835 + ((_e7848 - _e7835) * (_e7803 - f32(_e7818)))));
let _e7863 = global_1.member.member_13.member_7;
let _e7864 = bitcast<i32>(_e7863);
let _e7867 = global_1.member.member_13.member_8;
let _e7868 = bitcast<i32>(_e7867);
let _e7871 = global_1.member.member_13.member_9;
let _e7872 = bitcast<i32>(_e7871);
let _e7875 = global_1.member.member_13.member_4;
let _e7881 = global_1.member.member_13.member_5;
let _e7885 = f32(_e7864);
let _e7890 = (((((_e7567 + (_e7579 * _e7619)) - _e7875.member) / (_e7881.member - _e7875.member)) * _e7885) - 0.5f);
let _e7891 = (_e7885 - 1f);
let _e7893 = select(0f, _e7890, (_e7890 > 0f));
let _e7895 = select(_e7891, _e7893, (_e7893 < _e7891));
let _e7896 = f32(_e7868);
let _e7901 = (((((_e7568 + (_e7580 * _e7619)) - _e7875.member_1) / (_e7881.member_1 - _e7875.member_1)) * _e7896) - 0.5f);
let _e7902 = (_e7896 - 1f);
let _e7904 = select(0f, _e7901, (_e7901 > 0f));
let _e7906 = select(_e7902, _e7904, (_e7904 < _e7902));
let _e7907 = f32(_e7872);
let _e7912 = (((((_e7569 + (_e7581 * _e7619)) - _e7875.member_2) / (_e7881.member_2 - _e7875.member_2)) * _e7907) - 0.5f);
let _e7913 = (_e7907 - 1f);
let _e7915 = select(0f, _e7912, (_e7912 > 0f));
let _e7917 = select(_e7913, _e7915, (_e7915 < _e7913));
let _e7919 = select(0f, _e7895, (_e7895 > 0f));
let _e7921 = select(1e6f, _e7919, (_e7919 < 1e6f));
let _e7928 = select(0i, select(select(i32(_e7921), i32(-2147483648), (_e7921 < -2147483600f)), 2147483647i, (_e7921 > 2147483500f)), (_e7921 == _e7921));
let _e7932 = (_e7928 - select(0i, 1i, (_e7921 < f32(_e7928))));
let _e7934 = select(0f, _e7906, (_e7906 > 0f));
let _e7936 = select(1e6f, _e7934, (_e7934 < 1e6f));
let _e7943 = select(0i, select(select(i32(_e7936), i32(-2147483648), (_e7936 < -2147483600f)), 2147483647i, (_e7936 > 2147483500f)), (_e7936 == _e7936));
let _e7947 = (_e7943 - select(0i, 1i, (_e7936 < f32(_e7943))));
let _e7949 = select(0f, _e7917, (_e7917 > 0f));
let _e7951 = select(1e6f, _e7949, (_e7949 < 1e6f));
let _e7958 = select(0i, select(select(i32(_e7951), i32(-2147483648), (_e7951 < -2147483600f)), 2147483647i, (_e7951 > 2147483500f)), (_e7951 == _e7951));
let _e7962 = (_e7958 - select(0i, 1i, (_e7951 < f32(_e7958))));
let _e7966 = (_e7906 - f32(_e7947));
let _e7968 = (_e7917 - f32(_e7962));
local_142 = (_e7895 - f32(_e7932));
let _e7969 = (_e7932 + 1i);
let _e7971 = select(_e7969, 0i, (_e7969 < 0i));
if (_e7971 >= _e7864) {
phi_21623_ = (_e7864 - 1i);
} else {
phi_21623_ = _e7971;
}
let _e7975 = phi_21623_;
local_143 = (_e7975 - _e7932);
let _e7977 = (_e7947 + 1i);
let _e7979 = select(_e7977, 0i, (_e7977 < 0i));
if (_e7979 >= _e7868) {
phi_21636_ = (_e7868 - 1i);
} else {
phi_21636_ = _e7979;
}
let _e7983 = phi_21636_;
let _e7985 = ((_e7983 - _e7947) * _e7864);
let _e7986 = (_e7962 + 1i);
let _e7988 = select(_e7986, 0i, (_e7986 < 0i));
if (_e7988 >= _e7872) {
phi_21650_ = (_e7872 - 1i);
} else {
phi_21650_ = _e7988;
}
let _e7992 = phi_21650_;
let _e7998 = global_1.member.member_13.member_10;
let _e8004 = ((bitcast<i32>(_e7998) + (((_e7962 * _e7868) + _e7947) * _e7864)) + _e7932);
let _e8006 = (bitcast<i32>(_e265) - 1i);
let _e8008 = select(_e8006, _e8004, (_e8004 < _e8006));
let _e8013 = global_2.member[bitcast<u32>(select(0i, _e8008, (_e8008 > 0i)))];
let _e8014 = local_142;
let _e8017 = local_143;
let _e8018 = (_e8004 + _e8017);
let _e8020 = select(_e8006, _e8018, (_e8018 < _e8006));
let _e8025 = global_2.member[bitcast<u32>(select(0i, _e8020, (_e8020 > 0i)))];
let _e8026 = local_142;
let _e8029 = (1f - _e7966);
let _e8031 = (_e8004 + _e7985);
let _e8033 = select(_e8006, _e8031, (_e8031 < _e8006));
let _e8038 = global_2.member[bitcast<u32>(select(0i, _e8033, (_e8033 > 0i)))];
let _e8039 = local_142;
let _e8042 = local_143;
let _e8043 = (_e8031 + _e8042);
let _e8045 = select(_e8006, _e8043, (_e8043 < _e8006));
let _e8050 = global_2.member[bitcast<u32>(select(0i, _e8045, (_e8045 > 0i)))];
let _e8051 = local_142;
let _e8056 = (_e8004 + (((_e7992 - _e7962) * _e7864) * _e7868));
let _e8058 = select(_e8006, _e8056, (_e8056 < _e8006));
let _e8063 = global_2.member[bitcast<u32>(select(0i, _e8058, (_e8058 > 0i)))];
let _e8064 = local_142;
let _e8067 = local_143;
let _e8068 = (_e8056 + _e8067);
let _e8070 = select(_e8006, _e8068, (_e8068 < _e8006));
let _e8075 = global_2.member[bitcast<u32>(select(0i, _e8070, (_e8070 > 0i)))];
let _e8076 = local_142;
let _e8080 = (_e8056 + _e7985);
let _e8082 = select(_e8006, _e8080, (_e8080 < _e8006));
let _e8087 = global_2.member[bitcast<u32>(select(0i, _e8082, (_e8082 > 0i)))];
let _e8088 = local_142;
let _e8091 = local_143;
let _e8092 = (_e8080 + _e8091);
let _e8094 = select(_e8006, _e8092, (_e8092 < _e8006));
let _e8099 = global_2.member[bitcast<u32>(select(0i, _e8094, (_e8094 > 0i)))];
let _e8100 = local_142;
let _e8109 = ((_e7577 * (_e7707 * (0.25f / 3.1415927f))) * ((((((_e8013 * (1f - _e8014)) + (_e8025 * _e8026)) * _e8029) + (((_e8038 * (1f - _e8039)) + (_e8050 * _e8051)) * _e7966)) * (1f - _e7968)) + (((((_e8063 * (1f - _e8064)) + (_e8075 * _e8076)) * _e8029) + (((_e8087 * (1f - _e8088)) + (_e8099 * _e8100)) * _e7966)) * _e7968)));
let _e8112 = global_1.member.member_13.member_1;
let _e8121 = global_1.member.member_13.member;
let _e8126 = -((_e8121.member * _e7854));
let _e8128 = select(-87f, _e8126, (_e8126 > -87f));
let _e8130 = select(88f, _e8128, (_e8128 < 88f));
let _e8132 = ((_e8130 * 1.442695f) + 0.5f);
let _e8134 = select(-127f, _e8132, (_e8132 > -127f));
let _e8136 = select(128f, _e8134, (_e8134 < 128f));
let _e8143 = select(0i, select(select(i32(_e8136), i32(-2147483648), (_e8136 < -2147483600f)), 2147483647i, (_e8136 > 2147483500f)), (_e8136 == _e8136));
let _e8147 = (_e8143 - select(0i, 1i, (_e8136 < f32(_e8143))));
let _e8148 = f32(_e8147);
let _e8152 = ((_e8130 - (_e8148 * 0.6933594f)) - (_e8148 * -2.1219444e-4f));
let _e8174 = -((_e8121.member_1 * _e7854));
let _e8176 = select(-87f, _e8174, (_e8174 > -87f));
let _e8178 = select(88f, _e8176, (_e8176 < 88f));
let _e8180 = ((_e8178 * 1.442695f) + 0.5f);
let _e8182 = select(-127f, _e8180, (_e8180 > -127f));
let _e8184 = select(128f, _e8182, (_e8182 < 128f));
let _e8191 = select(0i, select(select(i32(_e8184), i32(-2147483648), (_e8184 < -2147483600f)), 2147483647i, (_e8184 > 2147483500f)), (_e8184 == _e8184));
let _e8195 = (_e8191 - select(0i, 1i, (_e8184 < f32(_e8191))));
let _e8196 = f32(_e8195);
let _e8200 = ((_e8178 - (_e8196 * 0.6933594f)) - (_e8196 * -2.1219444e-4f));
let _e8222 = -((_e8121.member_2 * _e7854));
let _e8224 = select(-87f, _e8222, (_e8222 > -87f));
let _e8226 = select(88f, _e8224, (_e8224 < 88f));
let _e8228 = ((_e8226 * 1.442695f) + 0.5f);
let _e8230 = select(-127f, _e8228, (_e8228 > -127f));
let _e8232 = select(128f, _e8230, (_e8230 < 128f));
let _e8239 = select(0i, select(select(i32(_e8232), i32(-2147483648), (_e8232 < -2147483600f)), 2147483647i, (_e8232 > 2147483500f)), (_e8232 == _e8232));
let _e8243 = (_e8239 - select(0i, 1i, (_e8232 < f32(_e8239))));
let _e8244 = f32(_e8243);
let _e8248 = ((_e8226 - (_e8244 * 0.6933594f)) - (_e8244 * -2.1219444e-4f));
let _e8275 = select(0f, _e7619, (((_e7622 >= 0f) && (_e7622 < _e691)) && (_e7619 > 0f)));
let _e8278 = ((_e8275 > 0f) && (_e8275 < _e7437));
if _e453 {
phi_22106_ = type_23(_e7337, _e7241);
} else {
phi_22106_ = type_23(_e7241, _e7337);
}
let _e8302 = phi_22106_;
let _e8305 = (_e7338 && _e8278);
let _e8308 = global_1.member.member_18.member;
let _e8309 = (((select(_e7363, (1f - _e7363), (_e7348 >= 0f)) - select(_e7382, (1f - _e7382), (_e7367 >= 0f))) * (1f / _e7345)) * _e8308);
let _e8313 = select(0f, ((((_e652 * _e8112.member) * ((1f + (_e8152 * (1f + (_e8152 * (0.5f + (_e8152 * (0.16666667f + (_e8152 * (0.041666668f + (_e8152 * (0.008333334f + (_e8152 * (0.001388889f + (_e8152 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8147 + 127i)) << bitcast<u32>(23i))))) * _e8109) * _e8309), _e8305);
let _e8314 = select(0f, ((((_e665 * _e8112.member_1) * ((1f + (_e8200 * (1f + (_e8200 * (0.5f + (_e8200 * (0.16666667f + (_e8200 * (0.041666668f + (_e8200 * (0.008333334f + (_e8200 * (0.001388889f + (_e8200 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8195 + 127i)) << bitcast<u32>(23i))))) * _e8109) * _e8309), _e8305);
let _e8315 = select(0f, ((((_e678 * _e8112.member_2) * ((1f + (_e8248 * (1f + (_e8248 * (0.5f + (_e8248 * (0.16666667f + (_e8248 * (0.041666668f + (_e8248 * (0.008333334f + (_e8248 * (0.001388889f + (_e8248 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8243 + 127i)) << bitcast<u32>(23i))))) * _e8109) * _e8309), _e8305);
let _e8319 = (bitcast<f32>((bitcast<u32>(_e8313) & 2147483647u)) >= 1073741800f);
let _e8320 = (1f / 1048576f);
let _e8323 = ((_e8313 * select(1f, _e8320, _e8319)) + 0.5f);
let _e8325 = select(-1073741800f, _e8323, (_e8323 > -1073741800f));
let _e8327 = select(1073741800f, _e8325, (_e8325 < 1073741800f));
let _e8334 = select(0i, select(select(i32(_e8327), i32(-2147483648), (_e8327 < -2147483600f)), 2147483647i, (_e8327 > 2147483500f)), (_e8327 == _e8327));
let _e8338 = (_e8334 - select(0i, 1i, (_e8327 < f32(_e8334))));
let _e8339 = select(0i, 20i, _e8319);
let _e8343 = (bitcast<u32>(_e8338) << bitcast<u32>((_e8339 & 31i)));
let _e8350 = bitcast<u32>(((_e8338 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e8339) & 31i))));
let _e8354 = (bitcast<f32>((bitcast<u32>(_e8314) & 2147483647u)) >= 1073741800f);
let _e8357 = ((_e8314 * select(1f, _e8320, _e8354)) + 0.5f);
let _e8359 = select(-1073741800f, _e8357, (_e8357 > -1073741800f));
let _e8361 = select(1073741800f, _e8359, (_e8359 < 1073741800f));
let _e8368 = select(0i, select(select(i32(_e8361), i32(-2147483648), (_e8361 < -2147483600f)), 2147483647i, (_e8361 > 2147483500f)), (_e8361 == _e8361));
let _e8372 = (_e8368 - select(0i, 1i, (_e8361 < f32(_e8368))));
let _e8373 = select(0i, 20i, _e8354);
let _e8377 = (bitcast<u32>(_e8372) << bitcast<u32>((_e8373 & 31i)));
let _e8384 = bitcast<u32>(((_e8372 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e8373) & 31i))));
let _e8388 = (bitcast<f32>((bitcast<u32>(_e8315) & 2147483647u)) >= 1073741800f);
let _e8391 = ((_e8315 * select(1f, _e8320, _e8388)) + 0.5f);
let _e8393 = select(-1073741800f, _e8391, (_e8391 > -1073741800f));
let _e8395 = select(1073741800f, _e8393, (_e8393 < 1073741800f));
let _e8402 = select(0i, select(select(i32(_e8395), i32(-2147483648), (_e8395 < -2147483600f)), 2147483647i, (_e8395 > 2147483500f)), (_e8395 == _e8395));
let _e8406 = (_e8402 - select(0i, 1i, (_e8395 < f32(_e8402))));
let _e8407 = select(0i, 20i, _e8388);
let _e8411 = (bitcast<u32>(_e8406) << bitcast<u32>((_e8407 & 31i)));
let _e8418 = bitcast<u32>(((_e8406 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e8407) & 31i))));
let _e8423 = global_1.member.member_18.member_2;
let _e8426 = global_1.member.member_18.member_3;
let _e8429 = global_1.member.member_18.member_4;
let _e8432 = global_1.member.member_18.member_5;
if _e982 {
phi_22305_ = 0u;
} else {
if (_e766 == 1u) {
phi_22304_ = _e8423;
} else {
if (_e766 == 2u) {
phi_22303_ = _e8426;
} else {
phi_22303_ = select(_e8432, _e8429, (_e766 == 3u));
}
let _e8438 = phi_22303_;
phi_22304_ = _e8438;
}
let _e8440 = phi_22304_;
phi_22305_ = _e8440;
}
let _e8442 = phi_22305_;
let _e8450 = bitcast<i32>(bitcast<u32>((((bitcast<i32>(_e8442) + (_e8302.member_1 * _e7210)) + _e8302.member) * 6i)));
if ((_e8343 | _e8350) == 0u) {
} else {
let _e8453 = bitcast<u32>(_e8450);
if (_e8453 < _e270) {
let _e8457 = atomicAdd((&global_8.member[_e8453]), _e8343);
phi_22339_ = _e8457;
} else {
phi_22339_ = 0u;
}
let _e8459 = phi_22339_;
let _e8463 = (_e8350 + select(0u, 1u, ((_e8459 + _e8343) < _e8343)));
if (_e8463 == 0u) {
} else {
let _e8465 = (_e8453 + 1u);
if (_e8465 < _e270) {
let _e8469 = atomicAdd((&global_8.member[_e8465]), _e8463);
}
}
}
if ((_e8377 | _e8384) == 0u) {
} else {
let _e8473 = bitcast<u32>((_e8450 + 2i));
if (_e8473 < _e270) {
let _e8477 = atomicAdd((&global_8.member[_e8473]), _e8377);
phi_22369_ = _e8477;
} else {
phi_22369_ = 0u;
}
let _e8479 = phi_22369_;
let _e8483 = (_e8384 + select(0u, 1u, ((_e8479 + _e8377) < _e8377)));
if (_e8483 == 0u) {
} else {
let _e8485 = (_e8473 + 1u);
if (_e8485 < _e270) {
let _e8489 = atomicAdd((&global_8.member[_e8485]), _e8483);
}
}
}
if ((_e8411 | _e8418) == 0u) {
} else {
let _e8493 = bitcast<u32>((_e8450 + 4i));
if (_e8493 < _e270) {
let _e8497 = atomicAdd((&global_8.member[_e8493]), _e8411);
phi_22399_ = _e8497;
} else {
phi_22399_ = 0u;
}
let _e8499 = phi_22399_;
let _e8503 = (_e8418 + select(0u, 1u, ((_e8499 + _e8411) < _e8411)));
if (_e8503 == 0u) {
} else {
let _e8505 = (_e8493 + 1u);
if (_e8505 < _e270) {
let _e8509 = atomicAdd((&global_8.member[_e8505]), _e8503);
}
}
}
let _e8510 = bitcast<i32>(bitcast<u32>(select(-1i, _e7337, (_e7338 && (!(((_e8278 && !(((((_e7241 * _e7233) == _e298) && (_e845 != _e766)) || ((((_e7241 + 1i) * _e7233) == _e692) && (_e923 != _e766))))) && ((_e8275 * (1f + (0.02f * _e7234))) < _e7458))) && (_e8275 <= _e7447))))));
if (_e8510 >= 0i) {
phi_22436_ = type_23(select(_e7332.member, _e8510, (_e8510 < _e7332.member)), select(_e7332.member_1, _e8510, (_e8510 > _e7332.member_1)));
} else {
phi_22436_ = _e7332;
}
let _e8520 = phi_22436_;
phi_20499_ = _e8520;
phi_20502_ = (_e7334 + 1i);
} else {
phi_20499_ = type_23();
phi_20502_ = i32();
}
let _e8523 = phi_20499_;
let _e8525 = phi_20502_;
continue;
continuing {
phi_20498_ = _e8523;
phi_20501_ = _e8525;
break if !(_e7338);
}
}
let _e25961 = local_241;
phi_20345_ = _e25961;
phi_20348_ = (_e7230 + 1i);
} else {
phi_20345_ = type_23();
phi_20348_ = i32();
}
let _e8529 = phi_20345_;
let _e8531 = phi_20348_;
continue;
continuing {
phi_20344_ = _e8529;
phi_20347_ = _e8531;
break if !(_e7231);
}
}
let _e8534 = local_231;
let _e8537 = local_232;
if (_e8534.member <= _e8537.member_1) {
let _e8542 = ((_e8537.member_1 + 1i) << bitcast<u32>(_e7199));
if (_e8542 <= _e981) {
phi_22453_ = (_e8542 - 1i);
} else {
phi_22453_ = _e981;
}
let _e8546 = phi_22453_;
let _e8548 = (_e8534.member << bitcast<u32>(_e7199));
let _e8550 = select(_e845, 0u, (_e845 == _e766));
let _e8554 = select(_e923, 0u, ((_e923 == _e766) || (_e923 == _e845)));
let _e8562 = ((select(0u, 1u, (_e766 > 0u)) + select(0u, 1u, (_e8550 > 0u))) + select(0u, 1u, (_e8554 > 0u)));
if (_e8562 == 0u) {
phi_22488_ = 0i;
loop {
let _e8565 = phi_22488_;
let _e8566 = (_e8565 < 16i);
if _e8566 {
let _e8568 = (_e976 + (_e8565 & 15i));
let _e8572 = (((f32(_e8568) + 0.5f) * 1f) - 0.5f);
let _e8576 = (-(((_e416 * _e8572) + _e442)) / _e429);
let _e8583 = bitcast<f32>((bitcast<u32>(((_e466 * _e8572) + ((_e479 * _e8576) + _e492))) & 2147483647u));
let _e8590 = bitcast<f32>((bitcast<u32>(((_e505 * _e8572) + ((_e518 * _e8576) + _e531))) & 2147483647u));
let _e8594 = (((0.5f * (_e8583 + _e8590)) / _e534) + _e717);
let _e8595 = (1f / 1f);
let _e8603 = ((((_e8576 + _e8594) + 0.5f) * _e8595) - 0.5f);
let _e8604 = f32(_e8548);
let _e8605 = f32(_e8546);
let _e8606 = (_e8604 - 1f);
let _e8608 = select(_e8606, _e8603, (_e8603 > _e8606));
let _e8610 = select(_e8605, _e8608, (_e8608 < _e8605));
let _e8617 = select(0i, select(select(i32(_e8610), i32(-2147483648), (_e8610 < -2147483600f)), 2147483647i, (_e8610 > 2147483500f)), (_e8610 == _e8610));
let _e8622 = (((((_e8576 - _e8594) + 0.5f) * _e8595) - 0.5f) + 1f);
let _e8623 = (_e8605 + 1f);
let _e8625 = select(_e8604, _e8622, (_e8622 > _e8604));
let _e8627 = select(_e8623, _e8625, (_e8625 < _e8623));
let _e8634 = select(0i, select(select(i32(_e8627), i32(-2147483648), (_e8627 < -2147483600f)), 2147483647i, (_e8627 > 2147483500f)), (_e8627 == _e8627));
let _e8645 = ((1e-4f * 1f) * _e534);
let _e8647 = select(_e8590, _e8583, (_e8583 > _e8590));
let _e8649 = select(_e8645, _e8647, (_e8647 > _e8645));
let _e8651 = select(_e8590, _e8583, (_e8583 < _e8590));
let _e8653 = select(_e8645, _e8651, (_e8651 > _e8645));
let _e8655 = (0.5f * (_e8649 + _e8653));
let _e8656 = (0.5f / _e8653);
let _e8657 = (1f / _e8649);
phi_22642_ = 0i;
loop {
let _e8659 = phi_22642_;
let _e8661 = (((_e8634 - select(0i, 1i, (_e8627 < f32(_e8634)))) + (_e8565 >> bitcast<u32>(4u))) + bitcast<i32>(_e8659));
let _e8662 = (_e8661 <= select(-1i, (_e8617 - select(0i, 1i, (_e8610 < f32(_e8617)))), (_e8568 <= _e980)));
if _e8662 {
let _e8668 = (((((f32(_e8661) + 0.5f) * 1f) - 0.5f) - _e8576) * _e534);
let _e8669 = (_e534 * 1f);
let _e8671 = (0.5f * _e8669);
let _e8672 = (_e8668 + _e8671);
let _e8673 = -(_e8672);
let _e8676 = (_e8655 - select(_e8673, _e8672, (_e8672 > _e8673)));
let _e8678 = select(0f, _e8676, (_e8676 > 0f));
let _e8680 = select(_e8653, _e8678, (_e8678 < _e8653));
let _e8683 = (_e8676 - _e8653);
let _e8687 = (((_e8680 * (_e8680 * _e8656)) + select(0f, _e8683, (_e8683 > 0f))) * _e8657);
let _e8691 = (_e8668 - _e8671);
let _e8692 = -(_e8691);
let _e8695 = (_e8655 - select(_e8692, _e8691, (_e8691 > _e8692)));
let _e8697 = select(0f, _e8695, (_e8695 > 0f));
let _e8699 = select(_e8653, _e8697, (_e8697 < _e8653));
let _e8702 = (_e8695 - _e8653);
let _e8706 = (((_e8699 * (_e8699 * _e8656)) + select(0f, _e8702, (_e8702 > 0f))) * _e8657);
if _e453 {
phi_22747_ = type_23(_e8661, _e8568);
} else {
phi_22747_ = type_23(_e8568, _e8661);
}
let _e8715 = phi_22747_;
let _e8719 = bitcast<i32>((_e927 * _e930));
local_140 = _e8719;
local_141 = ((_e8715.member_1 * _e931) + _e8715.member);
let _e8722 = local_140;
let _e8723 = local_141;
let _e8724 = (_e8722 + _e8723);
let _e8726 = (bitcast<i32>(_e259) - 1i);
let _e8728 = select(_e8726, _e8724, (_e8724 < _e8726));
let _e8733 = global_5.member[bitcast<u32>(select(0i, _e8728, (_e8728 > 0i)))];
let _e8734 = local_140;
let _e8736 = local_141;
let _e8737 = ((2i * _e8734) + _e8736);
let _e8739 = select(_e8726, _e8737, (_e8737 < _e8726));
let _e8744 = global_5.member[bitcast<u32>(select(0i, _e8739, (_e8739 > 0i)))];
let _e8745 = local_141;
let _e8747 = select(_e8726, _e8745, (_e8745 < _e8726));
let _e8752 = global_5.member[bitcast<u32>(select(0i, _e8747, (_e8747 > 0i)))];
let _e8753 = local_141;
let _e8764 = global_1.member.member_2.member;
let _e8765 = (((((f32(_e8715.member) + 0.5f) / f32(_e931)) * 2f) - 1f) * _e8764);
let _e8772 = global_1.member.member_2.member_1;
let _e8773 = ((1f - (((f32(_e8715.member_1) + 0.5f) / f32(_e932)) * 2f)) * _e8772);
let _e8775 = global_1.member.member_3;
let _e8783 = global_1.member.member_4;
let _e8790 = ((_e8775.member * _e8765) + (_e8783.member * _e8773));
let _e8791 = ((_e8775.member_1 * _e8765) + (_e8783.member_1 * _e8773));
let _e8792 = ((_e8775.member_2 * _e8765) + (_e8783.member_2 * _e8773));
let _e8795 = global_1.member.member_2.member_3;
let _e8796 = (_e8795 != 0u);
let _e8798 = global_1.member.member_5;
let _e8805 = select((_e8798.member + _e8790), _e8798.member, _e8796);
let _e8806 = select((_e8798.member_1 + _e8791), _e8798.member_1, _e8796);
let _e8807 = select((_e8798.member_2 + _e8792), _e8798.member_2, _e8796);
let _e8809 = global_1.member.member_6;
let _e8816 = select(_e8809.member, (_e8809.member + _e8790), _e8796);
let _e8817 = select(_e8809.member_1, (_e8809.member_1 + _e8791), _e8796);
let _e8818 = select(_e8809.member_2, (_e8809.member_2 + _e8792), _e8796);
let _e8823 = (((_e8805 * _e8805) + (_e8806 * _e8806)) + (_e8807 * _e8807));
let _e8826 = sqrt(select(0f, _e8823, (_e8823 > 0f)));
let _e8827 = (1f / _e8826);
let _e8828 = (_e8805 * _e8827);
let _e8829 = (_e8806 * _e8827);
let _e8830 = (_e8807 * _e8827);
let _e8831 = (_e575 - _e8816);
let _e8832 = (_e587 - _e8817);
let _e8833 = (_e600 - _e8818);
let _e8838 = (((_e8831 * _e8828) + (_e8832 * _e8829)) + (_e8833 * _e8830));
let _e8843 = (((_e8831 * _e613) + (_e8832 * _e626)) + (_e8833 * _e639));
let _e8848 = (((_e8828 * _e613) + (_e8829 * _e626)) + (_e8830 * _e639));
let _e8851 = ((_e8829 * _e639) - (_e8830 * _e626));
let _e8854 = ((_e8830 * _e613) - (_e8828 * _e639));
let _e8857 = ((_e8828 * _e626) - (_e8829 * _e613));
let _e8862 = (((_e8851 * _e8851) + (_e8854 * _e8854)) + (_e8857 * _e8857));
let _e8865 = (1f / select(1e-9f, _e8862, (_e8862 > 1e-9f)));
let _e8868 = ((_e8838 - (_e8848 * _e8843)) * _e8865);
let _e8871 = (((_e8848 * _e8838) - _e8843) * _e8865);
let _e8877 = -(_e8848);
let _e8880 = global_1.member.member_13.member_2;
let _e8881 = (_e8880 * _e8880);
let _e8885 = ((1f + _e8881) - ((2f * _e8880) * _e8877));
let _e8887 = select(1e-9f, _e8885, (_e8885 > 1e-9f));
let _e8899 = global_1.member.member_13.member_3;
if (_e8899 == 2u) {
let _e8904 = (0.5f - (0.5f * _e8877));
let _e8906 = select(0f, _e8904, (_e8904 > 0f));
let _e8910 = (sqrt(select(0f, _e8906, (_e8906 > 0f))) * 255f);
let _e8911 = (255f - 1f);
let _e8913 = select(0f, _e8910, (_e8910 > 0f));
let _e8915 = select(_e8911, _e8913, (_e8913 < _e8911));
let _e8922 = select(0i, select(select(i32(_e8915), i32(-2147483648), (_e8915 < -2147483600f)), 2147483647i, (_e8915 > 2147483500f)), (_e8915 == _e8915));
let _e8926 = (_e8922 - select(0i, 1i, (_e8915 < f32(_e8922))));
let _e8929 = global_1.member.member_13.member_11;
let _e8930 = bitcast<i32>(_e8929);
let _e8931 = (_e8930 + _e8926);
let _e8933 = (bitcast<i32>(_e265) - 1i);
let _e8935 = select(_e8933, _e8931, (_e8931 < _e8933));
let _e8940 = global_2.member[bitcast<u32>(select(0i, _e8935, (_e8935 > 0i)))];
let _e8942 = (_e8930 + (_e8926 + 1i));
let _e8944 = select(_e8933, _e8942, (_e8942 < _e8933));
let _e8949 = global_2.member[bitcast<u32>(select(0i, _e8944, (_e8944 > 0i)))];
phi_23174_ = (_e8940 + ((_e8949 - _e8940) * (_e8910 - f32(_e8926))));
} else {
phi_23174_ = select(((1f - _e8881) / (_e8887 * sqrt(select(0f, _e8887, (_e8887 > 0f))))), (0.75f * (1f + (_e8877 * _e8877))), (_e8899 == 1u));
}
let _e8956 = phi_23174_;
let _e8962 = global_1.member.member_12.member_12;
let _e8965 = global_1.member.member_12.member_4;
let _e8968 = global_1.member.member_12.member_13;
let _e8974 = global_1.member.member.member;
let _e8976 = (_e8871 / _e691);
local_137 = bitcast<i32>((_e8962 + (_e8965 * _e8968)));
local_138 = _e281;
local_139 = bitcast<i32>(_e8974);
let _e8979 = global_1.member.member_13.member_6;
let _e8980 = f32(_e8979);
let _e8982 = select(0f, _e8976, (_e8976 > 0f));
let _e8985 = (select(1f, _e8982, (_e8982 < 1f)) * _e8980);
let _e8986 = (_e8980 - 1f);
let _e8988 = select(0f, _e8986, (_e8986 > 0f));
let _e8990 = select(0f, _e8985, (_e8985 > 0f));
let _e8992 = select(_e8988, _e8990, (_e8990 < _e8988));
let _e8999 = select(0i, select(select(i32(_e8992), i32(-2147483648), (_e8992 < -2147483600f)), 2147483647i, (_e8992 > 2147483500f)), (_e8992 == _e8992));
let _e9003 = (_e8999 - select(0i, 1i, (_e8992 < f32(_e8999))));
if (_e9003 > 0i) {
let _e9006 = local_137;
let _e9007 = local_139;
let _e9010 = local_138;
let _e9011 = ((_e9006 + ((_e9003 - 1i) * _e9007)) + _e9010);
let _e9013 = (bitcast<i32>(_e268) - 1i);
let _e9015 = select(_e9013, _e9011, (_e9011 < _e9013));
let _e9020 = global_7.member[bitcast<u32>(select(0i, _e9015, (_e9015 > 0i)))];
phi_23280_ = _e9020;
} else {
phi_23280_ = 0f;
}
let _e9022 = phi_23280_;
let _e9023 = local_137;
let _e9024 = local_139;
let _e9027 = local_138;
let _e9028 = ((_e9023 + (_e9003 * _e9024)) + _e9027);
let _e9030 = (bitcast<i32>(_e268) - 1i);
let _e9032 = select(_e9030, _e9028, (_e9028 < _e9030));
let _e9037 = global_7.member[bitcast<u32>(select(0i, _e9032, (_e9032 > 0i)))];
let _e9044 = (_e8744 - _e8733);
let _e9047 = ((_e8868 - _e8733) / select(1e-9f, _e9044, (_e9044 > 1e-9f)));
local_134 = 0i;
local_135 = _e8753;
local_136 = _e8719;
let _e9049 = select(0f, _e9047, (_e9047 > 0f));
let _e9052 = (select(1f, _e9049, (_e9049 < 1f)) * _e8980);
let _e9054 = select(0f, _e9052, (_e9052 > 0f));
let _e9056 = select(_e8988, _e9054, (_e9054 < _e8988));
let _e9063 = select(0i, select(select(i32(_e9056), i32(-2147483648), (_e9056 < -2147483600f)), 2147483647i, (_e9056 > 2147483500f)), (_e9056 == _e9056));
let _e9067 = (_e9063 - select(0i, 1i, (_e9056 < f32(_e9063))));
if (_e9067 > 0i) {
let _e9070 = local_134;
let _e9071 = local_136;
let _e9074 = local_135;
let _e9075 = ((_e9070 + ((_e9067 - 1i) * _e9071)) + _e9074);
let _e9077 = select(_e9030, _e9075, (_e9075 < _e9030));
let _e9082 = global_7.member[bitcast<u32>(select(0i, _e9077, (_e9077 > 0i)))];
phi_23407_ = _e9082;
} else {
phi_23407_ = 0f;
}
let _e9084 = phi_23407_;
let _e9085 = local_134;
let _e9086 = local_136;
let _e9089 = local_135;
let _e9090 = ((_e9085 + (_e9067 * _e9086)) + _e9089);
let _e9092 = select(_e9030, _e9090, (_e9090 < _e9030));
let _e9097 = global_7.member[bitcast<u32>(select(0i, _e9092, (_e9092 > 0i)))];
let _e9103 = ((_e9022 + ((_e9037 - _e9022) * (_e8985 - f32(_e9003)))) + (_e9084 + ((_e9097 - _e9084) * (_e9052 - f32(_e9067)))));
let _e9112 = global_1.member.member_13.member_7;
let _e9113 = bitcast<i32>(_e9112);
let _e9116 = global_1.member.member_13.member_8;
let _e9117 = bitcast<i32>(_e9116);
let _e9120 = global_1.member.member_13.member_9;
let _e9121 = bitcast<i32>(_e9120);
let _e9124 = global_1.member.member_13.member_4;
let _e9130 = global_1.member.member_13.member_5;
let _e9134 = f32(_e9113);
let _e9139 = (((((_e8816 + (_e8828 * _e8868)) - _e9124.member) / (_e9130.member - _e9124.member)) * _e9134) - 0.5f);
let _e9140 = (_e9134 - 1f);
let _e9142 = select(0f, _e9139, (_e9139 > 0f));
let _e9144 = select(_e9140, _e9142, (_e9142 < _e9140));
let _e9145 = f32(_e9117);
let _e9150 = (((((_e8817 + (_e8829 * _e8868)) - _e9124.member_1) / (_e9130.member_1 - _e9124.member_1)) * _e9145) - 0.5f);
let _e9151 = (_e9145 - 1f);
let _e9153 = select(0f, _e9150, (_e9150 > 0f));
let _e9155 = select(_e9151, _e9153, (_e9153 < _e9151));
let _e9156 = f32(_e9121);
let _e9161 = (((((_e8818 + (_e8830 * _e8868)) - _e9124.member_2) / (_e9130.member_2 - _e9124.member_2)) * _e9156) - 0.5f);
let _e9162 = (_e9156 - 1f);
let _e9164 = select(0f, _e9161, (_e9161 > 0f));
let _e9166 = select(_e9162, _e9164, (_e9164 < _e9162));
let _e9168 = select(0f, _e9144, (_e9144 > 0f));
let _e9170 = select(1e6f, _e9168, (_e9168 < 1e6f));
let _e9177 = select(0i, select(select(i32(_e9170), i32(-2147483648), (_e9170 < -2147483600f)), 2147483647i, (_e9170 > 2147483500f)), (_e9170 == _e9170));
let _e9181 = (_e9177 - select(0i, 1i, (_e9170 < f32(_e9177))));
let _e9183 = select(0f, _e9155, (_e9155 > 0f));
let _e9185 = select(1e6f, _e9183, (_e9183 < 1e6f));
let _e9192 = select(0i, select(select(i32(_e9185), i32(-2147483648), (_e9185 < -2147483600f)), 2147483647i, (_e9185 > 2147483500f)), (_e9185 == _e9185));
let _e9196 = (_e9192 - select(0i, 1i, (_e9185 < f32(_e9192))));
let _e9198 = select(0f, _e9166, (_e9166 > 0f));
let _e9200 = select(1e6f, _e9198, (_e9198 < 1e6f));
let _e9207 = select(0i, select(select(i32(_e9200), i32(-2147483648), (_e9200 < -2147483600f)), 2147483647i, (_e9200 > 2147483500f)), (_e9200 == _e9200));
let _e9211 = (_e9207 - select(0i, 1i, (_e9200 < f32(_e9207))));
let _e9215 = (_e9155 - f32(_e9196));
let _e9217 = (_e9166 - f32(_e9211));
local_132 = (_e9144 - f32(_e9181));
let _e9218 = (_e9181 + 1i);
let _e9220 = select(_e9218, 0i, (_e9218 < 0i));
if (_e9220 >= _e9113) {
phi_23555_ = (_e9113 - 1i);
} else {
phi_23555_ = _e9220;
}
let _e9224 = phi_23555_;
local_133 = (_e9224 - _e9181);
let _e9226 = (_e9196 + 1i);
let _e9228 = select(_e9226, 0i, (_e9226 < 0i));
if (_e9228 >= _e9117) {
phi_23568_ = (_e9117 - 1i);
} else {
phi_23568_ = _e9228;
}
let _e9232 = phi_23568_;
let _e9234 = ((_e9232 - _e9196) * _e9113);
let _e9235 = (_e9211 + 1i);
let _e9237 = select(_e9235, 0i, (_e9235 < 0i));
if (_e9237 >= _e9121) {
phi_23582_ = (_e9121 - 1i);
} else {
phi_23582_ = _e9237;
}
let _e9241 = phi_23582_;
let _e9247 = global_1.member.member_13.member_10;
let _e9253 = ((bitcast<i32>(_e9247) + (((_e9211 * _e9117) + _e9196) * _e9113)) + _e9181);
let _e9255 = (bitcast<i32>(_e265) - 1i);
let _e9257 = select(_e9255, _e9253, (_e9253 < _e9255));
let _e9262 = global_2.member[bitcast<u32>(select(0i, _e9257, (_e9257 > 0i)))];
let _e9263 = local_132;
let _e9266 = local_133;
let _e9267 = (_e9253 + _e9266);
let _e9269 = select(_e9255, _e9267, (_e9267 < _e9255));
let _e9274 = global_2.member[bitcast<u32>(select(0i, _e9269, (_e9269 > 0i)))];
let _e9275 = local_132;
let _e9278 = (1f - _e9215);
let _e9280 = (_e9253 + _e9234);
let _e9282 = select(_e9255, _e9280, (_e9280 < _e9255));
let _e9287 = global_2.member[bitcast<u32>(select(0i, _e9282, (_e9282 > 0i)))];
let _e9288 = local_132;
let _e9291 = local_133;
let _e9292 = (_e9280 + _e9291);
let _e9294 = select(_e9255, _e9292, (_e9292 < _e9255));
let _e9299 = global_2.member[bitcast<u32>(select(0i, _e9294, (_e9294 > 0i)))];
let _e9300 = local_132;
let _e9305 = (_e9253 + (((_e9241 - _e9211) * _e9113) * _e9117));
let _e9307 = select(_e9255, _e9305, (_e9305 < _e9255));
let _e9312 = global_2.member[bitcast<u32>(select(0i, _e9307, (_e9307 > 0i)))];
let _e9313 = local_132;
let _e9316 = local_133;
let _e9317 = (_e9305 + _e9316);
let _e9319 = select(_e9255, _e9317, (_e9317 < _e9255));
let _e9324 = global_2.member[bitcast<u32>(select(0i, _e9319, (_e9319 > 0i)))];
let _e9325 = local_132;
let _e9329 = (_e9305 + _e9234);
let _e9331 = select(_e9255, _e9329, (_e9329 < _e9255));
let _e9336 = global_2.member[bitcast<u32>(select(0i, _e9331, (_e9331 > 0i)))];
let _e9337 = local_132;
let _e9340 = local_133;
let _e9341 = (_e9329 + _e9340);
let _e9343 = select(_e9255, _e9341, (_e9341 < _e9255));
let _e9348 = global_2.member[bitcast<u32>(select(0i, _e9343, (_e9343 > 0i)))];
let _e9349 = local_132;
let _e9358 = ((_e8826 * (_e8956 * (0.25f / 3.1415927f))) * ((((((_e9262 * (1f - _e9263)) + (_e9274 * _e9275)) * _e9278) + (((_e9287 * (1f - _e9288)) + (_e9299 * _e9300)) * _e9215)) * (1f - _e9217)) + (((((_e9312 * (1f - _e9313)) + (_e9324 * _e9325)) * _e9278) + (((_e9336 * (1f - _e9337)) + (_e9348 * _e9349)) * _e9215)) * _e9217)));
let _e9361 = global_1.member.member_13.member_1;
let _e9370 = global_1.member.member_13.member;
let _e9375 = -((_e9370.member * _e9103));
let _e9377 = select(-87f, _e9375, (_e9375 > -87f));
let _e9379 = select(88f, _e9377, (_e9377 < 88f));
let _e9381 = ((_e9379 * 1.442695f) + 0.5f);
let _e9383 = select(-127f, _e9381, (_e9381 > -127f));
let _e9385 = select(128f, _e9383, (_e9383 < 128f));
let _e9392 = select(0i, select(select(i32(_e9385), i32(-2147483648), (_e9385 < -2147483600f)), 2147483647i, (_e9385 > 2147483500f)), (_e9385 == _e9385));
let _e9396 = (_e9392 - select(0i, 1i, (_e9385 < f32(_e9392))));
let _e9397 = f32(_e9396);
let _e9401 = ((_e9379 - (_e9397 * 0.6933594f)) - (_e9397 * -2.1219444e-4f));
let _e9423 = -((_e9370.member_1 * _e9103));
let _e9425 = select(-87f, _e9423, (_e9423 > -87f));
let _e9427 = select(88f, _e9425, (_e9425 < 88f));
let _e9429 = ((_e9427 * 1.442695f) + 0.5f);
let _e9431 = select(-127f, _e9429, (_e9429 > -127f));
let _e9433 = select(128f, _e9431, (_e9431 < 128f));
let _e9440 = select(0i, select(select(i32(_e9433), i32(-2147483648), (_e9433 < -2147483600f)), 2147483647i, (_e9433 > 2147483500f)), (_e9433 == _e9433));
let _e9444 = (_e9440 - select(0i, 1i, (_e9433 < f32(_e9440))));
let _e9445 = f32(_e9444);
let _e9449 = ((_e9427 - (_e9445 * 0.6933594f)) - (_e9445 * -2.1219444e-4f));
let _e9471 = -((_e9370.member_2 * _e9103));
let _e9473 = select(-87f, _e9471, (_e9471 > -87f));
let _e9475 = select(88f, _e9473, (_e9473 < 88f));
let _e9477 = ((_e9475 * 1.442695f) + 0.5f);
let _e9479 = select(-127f, _e9477, (_e9477 > -127f));
let _e9481 = select(128f, _e9479, (_e9479 < 128f));
let _e9488 = select(0i, select(select(i32(_e9481), i32(-2147483648), (_e9481 < -2147483600f)), 2147483647i, (_e9481 > 2147483500f)), (_e9481 == _e9481));
let _e9492 = (_e9488 - select(0i, 1i, (_e9481 < f32(_e9488))));
let _e9493 = f32(_e9492);
let _e9497 = ((_e9475 - (_e9493 * 0.6933594f)) - (_e9493 * -2.1219444e-4f));
let _e9524 = select(0f, _e8868, (((_e8871 >= 0f) && (_e8871 < _e691)) && (_e8868 > 0f)));
if _e453 {
phi_24017_ = type_23(_e8661, _e8568);
} else {
phi_24017_ = type_23(_e8568, _e8661);
}
let _e9535 = phi_24017_;
let _e9538 = (_e8662 && (((_e9524 > 0f) && (_e9524 < _e8752)) && true));
let _e9541 = global_1.member.member_18.member;
let _e9542 = (((select(_e8687, (1f - _e8687), (_e8672 >= 0f)) - select(_e8706, (1f - _e8706), (_e8691 >= 0f))) * (1f / _e8669)) * _e9541);
let _e9546 = select(0f, (((((_e652 * _e9361.member) * ((1f + (_e9401 * (1f + (_e9401 * (0.5f + (_e9401 * (0.16666667f + (_e9401 * (0.041666668f + (_e9401 * (0.008333334f + (_e9401 * (0.001388889f + (_e9401 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9396 + 127i)) << bitcast<u32>(23i))))) * _e9358) * 1f) * _e9542), _e9538);
let _e9547 = select(0f, (((((_e665 * _e9361.member_1) * ((1f + (_e9449 * (1f + (_e9449 * (0.5f + (_e9449 * (0.16666667f + (_e9449 * (0.041666668f + (_e9449 * (0.008333334f + (_e9449 * (0.001388889f + (_e9449 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9444 + 127i)) << bitcast<u32>(23i))))) * _e9358) * 1f) * _e9542), _e9538);
let _e9548 = select(0f, (((((_e678 * _e9361.member_2) * ((1f + (_e9497 * (1f + (_e9497 * (0.5f + (_e9497 * (0.16666667f + (_e9497 * (0.041666668f + (_e9497 * (0.008333334f + (_e9497 * (0.001388889f + (_e9497 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9492 + 127i)) << bitcast<u32>(23i))))) * _e9358) * 1f) * _e9542), _e9538);
let _e9552 = (bitcast<f32>((bitcast<u32>(_e9546) & 2147483647u)) >= 1073741800f);
let _e9553 = (1f / 1048576f);
let _e9556 = ((_e9546 * select(1f, _e9553, _e9552)) + 0.5f);
let _e9558 = select(-1073741800f, _e9556, (_e9556 > -1073741800f));
let _e9560 = select(1073741800f, _e9558, (_e9558 < 1073741800f));
let _e9567 = select(0i, select(select(i32(_e9560), i32(-2147483648), (_e9560 < -2147483600f)), 2147483647i, (_e9560 > 2147483500f)), (_e9560 == _e9560));
let _e9571 = (_e9567 - select(0i, 1i, (_e9560 < f32(_e9567))));
let _e9572 = select(0i, 20i, _e9552);
let _e9576 = (bitcast<u32>(_e9571) << bitcast<u32>((_e9572 & 31i)));
let _e9583 = bitcast<u32>(((_e9571 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9572) & 31i))));
let _e9587 = (bitcast<f32>((bitcast<u32>(_e9547) & 2147483647u)) >= 1073741800f);
let _e9590 = ((_e9547 * select(1f, _e9553, _e9587)) + 0.5f);
let _e9592 = select(-1073741800f, _e9590, (_e9590 > -1073741800f));
let _e9594 = select(1073741800f, _e9592, (_e9592 < 1073741800f));
let _e9601 = select(0i, select(select(i32(_e9594), i32(-2147483648), (_e9594 < -2147483600f)), 2147483647i, (_e9594 > 2147483500f)), (_e9594 == _e9594));
let _e9605 = (_e9601 - select(0i, 1i, (_e9594 < f32(_e9601))));
let _e9606 = select(0i, 20i, _e9587);
let _e9610 = (bitcast<u32>(_e9605) << bitcast<u32>((_e9606 & 31i)));
let _e9617 = bitcast<u32>(((_e9605 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9606) & 31i))));
let _e9621 = (bitcast<f32>((bitcast<u32>(_e9548) & 2147483647u)) >= 1073741800f);
let _e9624 = ((_e9548 * select(1f, _e9553, _e9621)) + 0.5f);
let _e9626 = select(-1073741800f, _e9624, (_e9624 > -1073741800f));
let _e9628 = select(1073741800f, _e9626, (_e9626 < 1073741800f));
let _e9635 = select(0i, select(select(i32(_e9628), i32(-2147483648), (_e9628 < -2147483600f)), 2147483647i, (_e9628 > 2147483500f)), (_e9628 == _e9628));
let _e9639 = (_e9635 - select(0i, 1i, (_e9628 < f32(_e9635))));
let _e9640 = select(0i, 20i, _e9621);
let _e9644 = (bitcast<u32>(_e9639) << bitcast<u32>((_e9640 & 31i)));
let _e9651 = bitcast<u32>(((_e9639 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9640) & 31i))));
let _e9656 = bitcast<i32>(bitcast<u32>((((_e9535.member_1 * _e931) + _e9535.member) * 6i)));
if ((_e9576 | _e9583) == 0u) {
} else {
let _e9659 = bitcast<u32>(_e9656);
if (_e9659 < _e270) {
let _e9663 = atomicAdd((&global_8.member[_e9659]), _e9576);
phi_24250_ = _e9663;
} else {
phi_24250_ = 0u;
}
let _e9665 = phi_24250_;
let _e9669 = (_e9583 + select(0u, 1u, ((_e9665 + _e9576) < _e9576)));
if (_e9669 == 0u) {
} else {
let _e9671 = (_e9659 + 1u);
if (_e9671 < _e270) {
let _e9675 = atomicAdd((&global_8.member[_e9671]), _e9669);
}
}
}
if ((_e9610 | _e9617) == 0u) {
} else {
let _e9679 = bitcast<u32>((_e9656 + 2i));
if (_e9679 < _e270) {
let _e9683 = atomicAdd((&global_8.member[_e9679]), _e9610);
phi_24280_ = _e9683;
} else {
phi_24280_ = 0u;
}
let _e9685 = phi_24280_;
let _e9689 = (_e9617 + select(0u, 1u, ((_e9685 + _e9610) < _e9610)));
if (_e9689 == 0u) {
} else {
let _e9691 = (_e9679 + 1u);
if (_e9691 < _e270) {
let _e9695 = atomicAdd((&global_8.member[_e9691]), _e9689);
}
}
}
if ((_e9644 | _e9651) == 0u) {
} else {
let _e9699 = bitcast<u32>((_e9656 + 4i));
if (_e9699 < _e270) {
let _e9703 = atomicAdd((&global_8.member[_e9699]), _e9644);
phi_24310_ = _e9703;
} else {
phi_24310_ = 0u;
}
let _e9705 = phi_24310_;
let _e9709 = (_e9651 + select(0u, 1u, ((_e9705 + _e9644) < _e9644)));
if (_e9709 == 0u) {
} else {
let _e9711 = (_e9699 + 1u);
if (_e9711 < _e270) {
let _e9715 = atomicAdd((&global_8.member[_e9711]), _e9709);
}
}
}
phi_22643_ = (_e8659 + 1i);
} else {
phi_22643_ = i32();
}
let _e9718 = phi_22643_;
continue;
continuing {
phi_22642_ = _e9718;
break if !(_e8662);
}
}
phi_22489_ = (_e8565 + 1i);
} else {
phi_22489_ = i32();
}
let _e9722 = phi_22489_;
continue;
continuing {
phi_22488_ = _e9722;
break if !(_e8566);
}
}
} else {
if (_e8562 == 1u) {
phi_24359_ = 0i;
loop {
let _e9726 = phi_24359_;
let _e9727 = (_e9726 < 16i);
if _e9727 {
let _e9729 = (_e976 + (_e9726 & 15i));
let _e9731 = (f32(_e9729) + 0.5f);
let _e9733 = ((_e9731 * 1f) - 0.5f);
let _e9737 = (-(((_e416 * _e9733) + _e442)) / _e429);
let _e9744 = bitcast<f32>((bitcast<u32>(((_e466 * _e9733) + ((_e479 * _e9737) + _e492))) & 2147483647u));
let _e9751 = bitcast<f32>((bitcast<u32>(((_e505 * _e9733) + ((_e518 * _e9737) + _e531))) & 2147483647u));
let _e9755 = (((0.5f * (_e9744 + _e9751)) / _e534) + _e717);
let _e9756 = (1f / 1f);
let _e9764 = ((((_e9737 + _e9755) + 0.5f) * _e9756) - 0.5f);
let _e9765 = f32(_e8548);
let _e9766 = f32(_e8546);
let _e9767 = (_e9765 - 1f);
let _e9769 = select(_e9767, _e9764, (_e9764 > _e9767));
let _e9771 = select(_e9766, _e9769, (_e9769 < _e9766));
let _e9778 = select(0i, select(select(i32(_e9771), i32(-2147483648), (_e9771 < -2147483600f)), 2147483647i, (_e9771 > 2147483500f)), (_e9771 == _e9771));
let _e9783 = (((((_e9737 - _e9755) + 0.5f) * _e9756) - 0.5f) + 1f);
let _e9784 = (_e9766 + 1f);
let _e9786 = select(_e9765, _e9783, (_e9783 > _e9765));
let _e9788 = select(_e9784, _e9786, (_e9786 < _e9784));
let _e9795 = select(0i, select(select(i32(_e9788), i32(-2147483648), (_e9788 < -2147483600f)), 2147483647i, (_e9788 > 2147483500f)), (_e9788 == _e9788));
let _e9806 = ((1e-4f * 1f) * _e534);
let _e9808 = select(_e9751, _e9744, (_e9744 > _e9751));
let _e9810 = select(_e9806, _e9808, (_e9808 > _e9806));
let _e9812 = select(_e9751, _e9744, (_e9744 < _e9751));
let _e9814 = select(_e9806, _e9812, (_e9812 > _e9806));
let _e9816 = (0.5f * (_e9810 + _e9814));
let _e9817 = (0.5f / _e9814);
let _e9818 = (1f / _e9810);
phi_24513_ = 0i;
loop {
let _e9820 = phi_24513_;
let _e9822 = (((_e9795 - select(0i, 1i, (_e9788 < f32(_e9795)))) + (_e9726 >> bitcast<u32>(4u))) + bitcast<i32>(_e9820));
let _e9823 = (_e9822 <= select(-1i, (_e9778 - select(0i, 1i, (_e9771 < f32(_e9778)))), (_e9729 <= _e980)));
if _e9823 {
let _e9825 = (f32(_e9822) + 0.5f);
let _e9829 = ((((_e9825 * 1f) - 0.5f) - _e9737) * _e534);
let _e9830 = (_e534 * 1f);
let _e9832 = (0.5f * _e9830);
let _e9833 = (_e9829 + _e9832);
let _e9834 = -(_e9833);
let _e9837 = (_e9816 - select(_e9834, _e9833, (_e9833 > _e9834)));
let _e9839 = select(0f, _e9837, (_e9837 > 0f));
let _e9841 = select(_e9814, _e9839, (_e9839 < _e9814));
let _e9844 = (_e9837 - _e9814);
let _e9848 = (((_e9841 * (_e9841 * _e9817)) + select(0f, _e9844, (_e9844 > 0f))) * _e9818);
let _e9852 = (_e9829 - _e9832);
let _e9853 = -(_e9852);
let _e9856 = (_e9816 - select(_e9853, _e9852, (_e9852 > _e9853)));
let _e9858 = select(0f, _e9856, (_e9856 > 0f));
let _e9860 = select(_e9814, _e9858, (_e9858 < _e9814));
let _e9863 = (_e9856 - _e9814);
let _e9867 = (((_e9860 * (_e9860 * _e9817)) + select(0f, _e9863, (_e9863 > 0f))) * _e9818);
if _e453 {
phi_24618_ = type_23(_e9822, _e9729);
} else {
phi_24618_ = type_23(_e9729, _e9822);
}
let _e9876 = phi_24618_;
let _e9880 = bitcast<i32>((_e927 * _e930));
local_130 = _e9880;
local_131 = ((_e9876.member_1 * _e931) + _e9876.member);
let _e9883 = local_130;
let _e9884 = local_131;
let _e9885 = (_e9883 + _e9884);
let _e9887 = (bitcast<i32>(_e259) - 1i);
let _e9889 = select(_e9887, _e9885, (_e9885 < _e9887));
let _e9894 = global_5.member[bitcast<u32>(select(0i, _e9889, (_e9889 > 0i)))];
let _e9895 = local_130;
let _e9897 = local_131;
let _e9898 = ((2i * _e9895) + _e9897);
let _e9900 = select(_e9887, _e9898, (_e9898 < _e9887));
let _e9905 = global_5.member[bitcast<u32>(select(0i, _e9900, (_e9900 > 0i)))];
let _e9906 = local_131;
let _e9908 = select(_e9887, _e9906, (_e9906 < _e9887));
let _e9913 = global_5.member[bitcast<u32>(select(0i, _e9908, (_e9908 > 0i)))];
let _e9914 = local_131;
let _e9917 = f32(_e931);
let _e9918 = f32(_e932);
let _e9925 = global_1.member.member_2.member;
let _e9926 = (((((f32(_e9876.member) + 0.5f) / _e9917) * 2f) - 1f) * _e9925);
let _e9933 = global_1.member.member_2.member_1;
let _e9934 = ((1f - (((f32(_e9876.member_1) + 0.5f) / _e9918) * 2f)) * _e9933);
let _e9936 = global_1.member.member_3;
let _e9944 = global_1.member.member_4;
let _e9951 = ((_e9936.member * _e9926) + (_e9944.member * _e9934));
let _e9952 = ((_e9936.member_1 * _e9926) + (_e9944.member_1 * _e9934));
let _e9953 = ((_e9936.member_2 * _e9926) + (_e9944.member_2 * _e9934));
let _e9956 = global_1.member.member_2.member_3;
let _e9957 = (_e9956 != 0u);
let _e9959 = global_1.member.member_5;
let _e9966 = select((_e9959.member + _e9951), _e9959.member, _e9957);
let _e9967 = select((_e9959.member_1 + _e9952), _e9959.member_1, _e9957);
let _e9968 = select((_e9959.member_2 + _e9953), _e9959.member_2, _e9957);
let _e9970 = global_1.member.member_6;
let _e9977 = select(_e9970.member, (_e9970.member + _e9951), _e9957);
let _e9978 = select(_e9970.member_1, (_e9970.member_1 + _e9952), _e9957);
let _e9979 = select(_e9970.member_2, (_e9970.member_2 + _e9953), _e9957);
let _e9984 = (((_e9966 * _e9966) + (_e9967 * _e9967)) + (_e9968 * _e9968));
let _e9987 = sqrt(select(0f, _e9984, (_e9984 > 0f)));
let _e9988 = (1f / _e9987);
let _e9989 = (_e9966 * _e9988);
let _e9990 = (_e9967 * _e9988);
let _e9991 = (_e9968 * _e9988);
let _e9992 = (_e575 - _e9977);
let _e9993 = (_e587 - _e9978);
let _e9994 = (_e600 - _e9979);
let _e9999 = (((_e9992 * _e9989) + (_e9993 * _e9990)) + (_e9994 * _e9991));
let _e10004 = (((_e9992 * _e613) + (_e9993 * _e626)) + (_e9994 * _e639));
let _e10009 = (((_e9989 * _e613) + (_e9990 * _e626)) + (_e9991 * _e639));
let _e10012 = ((_e9990 * _e639) - (_e9991 * _e626));
let _e10015 = ((_e9991 * _e613) - (_e9989 * _e639));
let _e10018 = ((_e9989 * _e626) - (_e9990 * _e613));
let _e10023 = (((_e10012 * _e10012) + (_e10015 * _e10015)) + (_e10018 * _e10018));
let _e10026 = (1f / select(1e-9f, _e10023, (_e10023 > 1e-9f)));
let _e10029 = ((_e9999 - (_e10009 * _e10004)) * _e10026);
let _e10032 = (((_e10009 * _e9999) - _e10004) * _e10026);
let _e10038 = -(_e10009);
let _e10041 = global_1.member.member_13.member_2;
let _e10042 = (_e10041 * _e10041);
let _e10046 = ((1f + _e10042) - ((2f * _e10041) * _e10038));
let _e10048 = select(1e-9f, _e10046, (_e10046 > 1e-9f));
let _e10060 = global_1.member.member_13.member_3;
if (_e10060 == 2u) {
let _e10065 = (0.5f - (0.5f * _e10038));
let _e10067 = select(0f, _e10065, (_e10065 > 0f));
let _e10071 = (sqrt(select(0f, _e10067, (_e10067 > 0f))) * 255f);
let _e10072 = (255f - 1f);
let _e10074 = select(0f, _e10071, (_e10071 > 0f));
let _e10076 = select(_e10072, _e10074, (_e10074 < _e10072));
let _e10083 = select(0i, select(select(i32(_e10076), i32(-2147483648), (_e10076 < -2147483600f)), 2147483647i, (_e10076 > 2147483500f)), (_e10076 == _e10076));
let _e10087 = (_e10083 - select(0i, 1i, (_e10076 < f32(_e10083))));
let _e10090 = global_1.member.member_13.member_11;
let _e10091 = bitcast<i32>(_e10090);
let _e10092 = (_e10091 + _e10087);
let _e10094 = (bitcast<i32>(_e265) - 1i);
let _e10096 = select(_e10094, _e10092, (_e10092 < _e10094));
let _e10101 = global_2.member[bitcast<u32>(select(0i, _e10096, (_e10096 > 0i)))];
let _e10103 = (_e10091 + (_e10087 + 1i));
let _e10105 = select(_e10094, _e10103, (_e10103 < _e10094));
let _e10110 = global_2.member[bitcast<u32>(select(0i, _e10105, (_e10105 > 0i)))];
phi_25045_ = (_e10101 + ((_e10110 - _e10101) * (_e10071 - f32(_e10087))));
} else {
phi_25045_ = select(((1f - _e10042) / (_e10048 * sqrt(select(0f, _e10048, (_e10048 > 0f))))), (0.75f * (1f + (_e10038 * _e10038))), (_e10060 == 1u));
}
let _e10117 = phi_25045_;
let _e10123 = global_1.member.member_12.member_12;
let _e10126 = global_1.member.member_12.member_4;
let _e10129 = global_1.member.member_12.member_13;
let _e10135 = global_1.member.member.member;
let _e10137 = (_e10032 / _e691);
local_127 = bitcast<i32>((_e10123 + (_e10126 * _e10129)));
local_128 = _e281;
local_129 = bitcast<i32>(_e10135);
let _e10140 = global_1.member.member_13.member_6;
let _e10141 = f32(_e10140);
let _e10143 = select(0f, _e10137, (_e10137 > 0f));
let _e10146 = (select(1f, _e10143, (_e10143 < 1f)) * _e10141);
let _e10147 = (_e10141 - 1f);
let _e10149 = select(0f, _e10147, (_e10147 > 0f));
let _e10151 = select(0f, _e10146, (_e10146 > 0f));
let _e10153 = select(_e10149, _e10151, (_e10151 < _e10149));
let _e10160 = select(0i, select(select(i32(_e10153), i32(-2147483648), (_e10153 < -2147483600f)), 2147483647i, (_e10153 > 2147483500f)), (_e10153 == _e10153));
let _e10164 = (_e10160 - select(0i, 1i, (_e10153 < f32(_e10160))));
if (_e10164 > 0i) {
let _e10167 = local_127;
let _e10168 = local_129;
let _e10171 = local_128;
let _e10172 = ((_e10167 + ((_e10164 - 1i) * _e10168)) + _e10171);
let _e10174 = (bitcast<i32>(_e268) - 1i);
let _e10176 = select(_e10174, _e10172, (_e10172 < _e10174));
let _e10181 = global_7.member[bitcast<u32>(select(0i, _e10176, (_e10176 > 0i)))];
phi_25151_ = _e10181;
} else {
phi_25151_ = 0f;
}
let _e10183 = phi_25151_;
let _e10184 = local_127;
let _e10185 = local_129;
let _e10188 = local_128;
let _e10189 = ((_e10184 + (_e10164 * _e10185)) + _e10188);
let _e10191 = (bitcast<i32>(_e268) - 1i);
let _e10193 = select(_e10191, _e10189, (_e10189 < _e10191));
let _e10198 = global_7.member[bitcast<u32>(select(0i, _e10193, (_e10193 > 0i)))];
let _e10205 = (_e9905 - _e9894);
let _e10208 = ((_e10029 - _e9894) / select(1e-9f, _e10205, (_e10205 > 1e-9f)));
local_124 = 0i;
local_125 = _e9914;
local_126 = _e9880;
let _e10210 = select(0f, _e10208, (_e10208 > 0f));
let _e10213 = (select(1f, _e10210, (_e10210 < 1f)) * _e10141);
let _e10215 = select(0f, _e10213, (_e10213 > 0f));
let _e10217 = select(_e10149, _e10215, (_e10215 < _e10149));
let _e10224 = select(0i, select(select(i32(_e10217), i32(-2147483648), (_e10217 < -2147483600f)), 2147483647i, (_e10217 > 2147483500f)), (_e10217 == _e10217));
let _e10228 = (_e10224 - select(0i, 1i, (_e10217 < f32(_e10224))));
if (_e10228 > 0i) {
let _e10231 = local_124;
let _e10232 = local_126;
let _e10235 = local_125;
let _e10236 = ((_e10231 + ((_e10228 - 1i) * _e10232)) + _e10235);
let _e10238 = select(_e10191, _e10236, (_e10236 < _e10191));
let _e10243 = global_7.member[bitcast<u32>(select(0i, _e10238, (_e10238 > 0i)))];
phi_25278_ = _e10243;
} else {
phi_25278_ = 0f;
}
let _e10245 = phi_25278_;
let _e10246 = local_124;
let _e10247 = local_126;
let _e10250 = local_125;
let _e10251 = ((_e10246 + (_e10228 * _e10247)) + _e10250);
let _e10253 = select(_e10191, _e10251, (_e10251 < _e10191));
let _e10258 = global_7.member[bitcast<u32>(select(0i, _e10253, (_e10253 > 0i)))];
let _e10264 = ((_e10183 + ((_e10198 - _e10183) * (_e10146 - f32(_e10164)))) + (_e10245 + ((_e10258 - _e10245) * (_e10213 - f32(_e10228)))));
let _e10273 = global_1.member.member_13.member_7;
let _e10274 = bitcast<i32>(_e10273);
let _e10277 = global_1.member.member_13.member_8;
let _e10278 = bitcast<i32>(_e10277);
let _e10281 = global_1.member.member_13.member_9;
let _e10282 = bitcast<i32>(_e10281);
let _e10285 = global_1.member.member_13.member_4;
let _e10291 = global_1.member.member_13.member_5;
let _e10295 = f32(_e10274);
let _e10300 = (((((_e9977 + (_e9989 * _e10029)) - _e10285.member) / (_e10291.member - _e10285.member)) * _e10295) - 0.5f);
let _e10301 = (_e10295 - 1f);
let _e10303 = select(0f, _e10300, (_e10300 > 0f));
let _e10305 = select(_e10301, _e10303, (_e10303 < _e10301));
let _e10306 = f32(_e10278);
let _e10311 = (((((_e9978 + (_e9990 * _e10029)) - _e10285.member_1) / (_e10291.member_1 - _e10285.member_1)) * _e10306) - 0.5f);
let _e10312 = (_e10306 - 1f);
let _e10314 = select(0f, _e10311, (_e10311 > 0f));
let _e10316 = select(_e10312, _e10314, (_e10314 < _e10312));
let _e10317 = f32(_e10282);
let _e10322 = (((((_e9979 + (_e9991 * _e10029)) - _e10285.member_2) / (_e10291.member_2 - _e10285.member_2)) * _e10317) - 0.5f);
let _e10323 = (_e10317 - 1f);
let _e10325 = select(0f, _e10322, (_e10322 > 0f));
let _e10327 = select(_e10323, _e10325, (_e10325 < _e10323));
let _e10329 = select(0f, _e10305, (_e10305 > 0f));
let _e10331 = select(1e6f, _e10329, (_e10329 < 1e6f));
let _e10338 = select(0i, select(select(i32(_e10331), i32(-2147483648), (_e10331 < -2147483600f)), 2147483647i, (_e10331 > 2147483500f)), (_e10331 == _e10331));
let _e10342 = (_e10338 - select(0i, 1i, (_e10331 < f32(_e10338))));
let _e10344 = select(0f, _e10316, (_e10316 > 0f));
let _e10346 = select(1e6f, _e10344, (_e10344 < 1e6f));
let _e10353 = select(0i, select(select(i32(_e10346), i32(-2147483648), (_e10346 < -2147483600f)), 2147483647i, (_e10346 > 2147483500f)), (_e10346 == _e10346));
let _e10357 = (_e10353 - select(0i, 1i, (_e10346 < f32(_e10353))));
let _e10359 = select(0f, _e10327, (_e10327 > 0f));
let _e10361 = select(1e6f, _e10359, (_e10359 < 1e6f));
let _e10368 = select(0i, select(select(i32(_e10361), i32(-2147483648), (_e10361 < -2147483600f)), 2147483647i, (_e10361 > 2147483500f)), (_e10361 == _e10361));
let _e10372 = (_e10368 - select(0i, 1i, (_e10361 < f32(_e10368))));
let _e10376 = (_e10316 - f32(_e10357));
let _e10378 = (_e10327 - f32(_e10372));
local_122 = (_e10305 - f32(_e10342));
let _e10379 = (_e10342 + 1i);
let _e10381 = select(_e10379, 0i, (_e10379 < 0i));
if (_e10381 >= _e10274) {
phi_25426_ = (_e10274 - 1i);
} else {
phi_25426_ = _e10381;
}
let _e10385 = phi_25426_;
local_123 = (_e10385 - _e10342);
let _e10387 = (_e10357 + 1i);
let _e10389 = select(_e10387, 0i, (_e10387 < 0i));
if (_e10389 >= _e10278) {
phi_25439_ = (_e10278 - 1i);
} else {
phi_25439_ = _e10389;
}
let _e10393 = phi_25439_;
let _e10395 = ((_e10393 - _e10357) * _e10274);
let _e10396 = (_e10372 + 1i);
let _e10398 = select(_e10396, 0i, (_e10396 < 0i));
if (_e10398 >= _e10282) {
phi_25453_ = (_e10282 - 1i);
} else {
phi_25453_ = _e10398;
}
let _e10402 = phi_25453_;
let _e10408 = global_1.member.member_13.member_10;
let _e10414 = ((bitcast<i32>(_e10408) + (((_e10372 * _e10278) + _e10357) * _e10274)) + _e10342);
let _e10416 = (bitcast<i32>(_e265) - 1i);
let _e10418 = select(_e10416, _e10414, (_e10414 < _e10416));
let _e10423 = global_2.member[bitcast<u32>(select(0i, _e10418, (_e10418 > 0i)))];
let _e10424 = local_122;
let _e10427 = local_123;
let _e10428 = (_e10414 + _e10427);
let _e10430 = select(_e10416, _e10428, (_e10428 < _e10416));
let _e10435 = global_2.member[bitcast<u32>(select(0i, _e10430, (_e10430 > 0i)))];
let _e10436 = local_122;
let _e10439 = (1f - _e10376);
let _e10441 = (_e10414 + _e10395);
let _e10443 = select(_e10416, _e10441, (_e10441 < _e10416));
let _e10448 = global_2.member[bitcast<u32>(select(0i, _e10443, (_e10443 > 0i)))];
let _e10449 = local_122;
let _e10452 = local_123;
let _e10453 = (_e10441 + _e10452);
let _e10455 = select(_e10416, _e10453, (_e10453 < _e10416));
let _e10460 = global_2.member[bitcast<u32>(select(0i, _e10455, (_e10455 > 0i)))];
let _e10461 = local_122;
let _e10466 = (_e10414 + (((_e10402 - _e10372) * _e10274) * _e10278));
let _e10468 = select(_e10416, _e10466, (_e10466 < _e10416));
let _e10473 = global_2.member[bitcast<u32>(select(0i, _e10468, (_e10468 > 0i)))];
let _e10474 = local_122;
let _e10477 = local_123;
let _e10478 = (_e10466 + _e10477);
let _e10480 = select(_e10416, _e10478, (_e10478 < _e10416));
let _e10485 = global_2.member[bitcast<u32>(select(0i, _e10480, (_e10480 > 0i)))];
let _e10486 = local_122;
let _e10490 = (_e10466 + _e10395);
let _e10492 = select(_e10416, _e10490, (_e10490 < _e10416));
let _e10497 = global_2.member[bitcast<u32>(select(0i, _e10492, (_e10492 > 0i)))];
let _e10498 = local_122;
let _e10501 = local_123;
let _e10502 = (_e10490 + _e10501);
let _e10504 = select(_e10416, _e10502, (_e10502 < _e10416));
let _e10509 = global_2.member[bitcast<u32>(select(0i, _e10504, (_e10504 > 0i)))];
let _e10510 = local_122;
let _e10519 = ((_e9987 * (_e10117 * (0.25f / 3.1415927f))) * ((((((_e10423 * (1f - _e10424)) + (_e10435 * _e10436)) * _e10439) + (((_e10448 * (1f - _e10449)) + (_e10460 * _e10461)) * _e10376)) * (1f - _e10378)) + (((((_e10473 * (1f - _e10474)) + (_e10485 * _e10486)) * _e10439) + (((_e10497 * (1f - _e10498)) + (_e10509 * _e10510)) * _e10376)) * _e10378)));
let _e10522 = global_1.member.member_13.member_1;
let _e10531 = global_1.member.member_13.member;
let _e10536 = -((_e10531.member * _e10264));
let _e10538 = select(-87f, _e10536, (_e10536 > -87f));
let _e10540 = select(88f, _e10538, (_e10538 < 88f));
let _e10542 = ((_e10540 * 1.442695f) + 0.5f);
let _e10544 = select(-127f, _e10542, (_e10542 > -127f));
let _e10546 = select(128f, _e10544, (_e10544 < 128f));
let _e10553 = select(0i, select(select(i32(_e10546), i32(-2147483648), (_e10546 < -2147483600f)), 2147483647i, (_e10546 > 2147483500f)), (_e10546 == _e10546));
let _e10557 = (_e10553 - select(0i, 1i, (_e10546 < f32(_e10553))));
let _e10558 = f32(_e10557);
let _e10562 = ((_e10540 - (_e10558 * 0.6933594f)) - (_e10558 * -2.1219444e-4f));
let _e10584 = -((_e10531.member_1 * _e10264));
let _e10586 = select(-87f, _e10584, (_e10584 > -87f));
let _e10588 = select(88f, _e10586, (_e10586 < 88f));
let _e10590 = ((_e10588 * 1.442695f) + 0.5f);
let _e10592 = select(-127f, _e10590, (_e10590 > -127f));
let _e10594 = select(128f, _e10592, (_e10592 < 128f));
let _e10601 = select(0i, select(select(i32(_e10594), i32(-2147483648), (_e10594 < -2147483600f)), 2147483647i, (_e10594 > 2147483500f)), (_e10594 == _e10594));
let _e10605 = (_e10601 - select(0i, 1i, (_e10594 < f32(_e10601))));
let _e10606 = f32(_e10605);
let _e10610 = ((_e10588 - (_e10606 * 0.6933594f)) - (_e10606 * -2.1219444e-4f));
let _e10632 = -((_e10531.member_2 * _e10264));
let _e10634 = select(-87f, _e10632, (_e10632 > -87f));
let _e10636 = select(88f, _e10634, (_e10634 < 88f));
let _e10638 = ((_e10636 * 1.442695f) + 0.5f);
let _e10640 = select(-127f, _e10638, (_e10638 > -127f));
let _e10642 = select(128f, _e10640, (_e10640 < 128f));
let _e10649 = select(0i, select(select(i32(_e10642), i32(-2147483648), (_e10642 < -2147483600f)), 2147483647i, (_e10642 > 2147483500f)), (_e10642 == _e10642));
let _e10653 = (_e10649 - select(0i, 1i, (_e10642 < f32(_e10649))));
let _e10654 = f32(_e10653);
let _e10658 = ((_e10636 - (_e10654 * 0.6933594f)) - (_e10654 * -2.1219444e-4f));
let _e10685 = select(0f, _e10029, (((_e10032 >= 0f) && (_e10032 < _e691)) && (_e10029 > 0f)));
let _e10687 = ((_e766 + _e8550) + _e8554);
let _e10688 = (_e10687 & 31u);
let _e10690 = (1u << bitcast<u32>(_e10688));
let _e10699 = bitcast<i32>((((_e927 + _e10690) - 1u) >> bitcast<u32>(_e10688)));
let _e10700 = bitcast<i32>((((_e930 + _e10690) - 1u) >> bitcast<u32>(_e10688)));
if _e453 {
phi_25914_ = type_23(_e10700, _e10699);
} else {
phi_25914_ = type_23(_e10699, _e10700);
}
let _e10704 = phi_25914_;
let _e10709 = f32((1i << bitcast<u32>(_e10688)));
let _e10710 = (1f / _e10709);
let _e10712 = ((_e9731 * _e10710) - 0.5f);
let _e10714 = ((_e9825 * _e10710) - 0.5f);
let _e10716 = select(-1f, _e10712, (_e10712 > -1f));
let _e10718 = select(1e6f, _e10716, (_e10716 < 1e6f));
let _e10725 = select(0i, select(select(i32(_e10718), i32(-2147483648), (_e10718 < -2147483600f)), 2147483647i, (_e10718 > 2147483500f)), (_e10718 == _e10718));
let _e10729 = (_e10725 - select(0i, 1i, (_e10718 < f32(_e10725))));
let _e10731 = select(-1f, _e10714, (_e10714 > -1f));
let _e10733 = select(1e6f, _e10731, (_e10731 < 1e6f));
let _e10740 = select(0i, select(select(i32(_e10733), i32(-2147483648), (_e10733 < -2147483600f)), 2147483647i, (_e10733 > 2147483500f)), (_e10733 == _e10733));
let _e10744 = (_e10740 - select(0i, 1i, (_e10733 < f32(_e10740))));
let _e10746 = (_e10712 - f32(_e10729));
let _e10748 = (_e10714 - f32(_e10744));
let _e10749 = (1f - _e10746);
let _e10750 = (1f - _e10748);
let _e10753 = select(_e10729, 0i, (_e10729 < 0i));
let _e10754 = (_e10753 >= _e10704.member);
if _e10754 {
phi_25992_ = (_e10704.member - 1i);
} else {
phi_25992_ = _e10753;
}
let _e10757 = phi_25992_;
let _e10759 = select(_e10744, 0i, (_e10744 < 0i));
let _e10760 = (_e10759 >= _e10704.member_1);
if _e10760 {
phi_26003_ = (_e10704.member_1 - 1i);
} else {
phi_26003_ = _e10759;
}
let _e10763 = phi_26003_;
let _e10767 = (((f32(_e10757) + 0.5f) * _e10709) - 0.5f);
let _e10771 = (((f32(_e10763) + 0.5f) * _e10709) - 0.5f);
if _e453 {
phi_26031_ = type_23(_e10763, _e10757);
} else {
phi_26031_ = type_23(_e10757, _e10763);
}
let _e10777 = phi_26031_;
let _e10783 = bitcast<i32>(((_e927 + 1u) >> bitcast<u32>(1u)));
let _e10786 = global_1.member.member_18.member_6;
let _e10789 = global_1.member.member_18.member_7;
let _e10792 = global_1.member.member_18.member_8;
let _e10793 = (_e10687 == 0u);
if _e10793 {
phi_26082_ = 0u;
} else {
if (_e10687 == 1u) {
phi_26081_ = 0u;
} else {
if (_e10687 == 2u) {
phi_26080_ = _e10786;
} else {
phi_26080_ = select(_e10792, _e10789, (_e10687 == 3u));
}
let _e10799 = phi_26080_;
phi_26081_ = _e10799;
}
let _e10801 = phi_26081_;
phi_26082_ = _e10801;
}
let _e10803 = phi_26082_;
local_120 = (((bitcast<i32>(_e10803) + _e10777.member_1) * _e10783) + _e10777.member);
let _e10808 = local_120;
let _e10810 = (bitcast<i32>(_e262) - 1i);
let _e10812 = select(_e10810, _e10808, (_e10808 < _e10810));
let _e10817 = global_6.member[bitcast<u32>(select(0i, _e10812, (_e10812 > 0i)))];
let _e10822 = (((((select(_e10767, _e10771, _e453) + 0.5f) / _e9917) * 2f) - 1f) * _e9925);
let _e10827 = ((1f - (((select(_e10771, _e10767, _e453) + 0.5f) / _e9918) * 2f)) * _e9933);
let _e10834 = ((_e9936.member * _e10822) + (_e9944.member * _e10827));
let _e10835 = ((_e9936.member_1 * _e10822) + (_e9944.member_1 * _e10827));
let _e10836 = ((_e9936.member_2 * _e10822) + (_e9944.member_2 * _e10827));
let _e10840 = select((_e9959.member + _e10834), _e9959.member, _e9957);
let _e10841 = select((_e9959.member_1 + _e10835), _e9959.member_1, _e9957);
let _e10842 = select((_e9959.member_2 + _e10836), _e9959.member_2, _e9957);
let _e10853 = (((_e10840 * _e10840) + (_e10841 * _e10841)) + (_e10842 * _e10842));
let _e10857 = (1f / sqrt(select(0f, _e10853, (_e10853 > 0f))));
let _e10858 = (_e10840 * _e10857);
let _e10859 = (_e10841 * _e10857);
let _e10860 = (_e10842 * _e10857);
let _e10861 = (_e575 - select(_e9970.member, (_e9970.member + _e10834), _e9957));
let _e10862 = (_e587 - select(_e9970.member_1, (_e9970.member_1 + _e10835), _e9957));
let _e10863 = (_e600 - select(_e9970.member_2, (_e9970.member_2 + _e10836), _e9957));
let _e10868 = (((_e10861 * _e10858) + (_e10862 * _e10859)) + (_e10863 * _e10860));
let _e10873 = (((_e10861 * _e613) + (_e10862 * _e626)) + (_e10863 * _e639));
let _e10878 = (((_e10858 * _e613) + (_e10859 * _e626)) + (_e10860 * _e639));
let _e10881 = ((_e10859 * _e639) - (_e10860 * _e626));
let _e10884 = ((_e10860 * _e613) - (_e10858 * _e639));
let _e10887 = ((_e10858 * _e626) - (_e10859 * _e613));
let _e10892 = (((_e10881 * _e10881) + (_e10884 * _e10884)) + (_e10887 * _e10887));
let _e10895 = (1f / select(1e-9f, _e10892, (_e10892 > 1e-9f)));
let _e10898 = ((_e10868 - (_e10878 * _e10873)) * _e10895);
let _e10901 = (((_e10878 * _e10868) - _e10873) * _e10895);
let _e10907 = select(0f, _e10898, (((_e10901 >= 0f) && (_e10901 < _e691)) && (_e10898 > 0f)));
let _e10909 = (_e10757 << bitcast<u32>(_e10688));
let _e10921 = (_e10729 + 1i);
let _e10924 = select(_e10921, 0i, (_e10921 < 0i));
let _e10925 = (_e10924 >= _e10704.member);
if _e10925 {
phi_26743_ = (_e10704.member - 1i);
} else {
phi_26743_ = _e10924;
}
let _e10928 = phi_26743_;
if _e10760 {
phi_26754_ = (_e10704.member_1 - 1i);
} else {
phi_26754_ = _e10759;
}
let _e10931 = phi_26754_;
let _e10935 = (((f32(_e10928) + 0.5f) * _e10709) - 0.5f);
let _e10939 = (((f32(_e10931) + 0.5f) * _e10709) - 0.5f);
if _e453 {
phi_26782_ = type_23(_e10931, _e10928);
} else {
phi_26782_ = type_23(_e10928, _e10931);
}
let _e10945 = phi_26782_;
if _e10793 {
phi_26833_ = 0u;
} else {
if (_e10687 == 1u) {
phi_26832_ = 0u;
} else {
if (_e10687 == 2u) {
phi_26831_ = _e10786;
} else {
phi_26831_ = select(_e10792, _e10789, (_e10687 == 3u));
}
let _e10953 = phi_26831_;
phi_26832_ = _e10953;
}
let _e10955 = phi_26832_;
phi_26833_ = _e10955;
}
let _e10957 = phi_26833_;
local_118 = (((bitcast<i32>(_e10957) + _e10945.member_1) * _e10783) + _e10945.member);
let _e10962 = local_118;
let _e10964 = select(_e10810, _e10962, (_e10962 < _e10810));
let _e10969 = global_6.member[bitcast<u32>(select(0i, _e10964, (_e10964 > 0i)))];
let _e10974 = (((((select(_e10935, _e10939, _e453) + 0.5f) / _e9917) * 2f) - 1f) * _e9925);
let _e10979 = ((1f - (((select(_e10939, _e10935, _e453) + 0.5f) / _e9918) * 2f)) * _e9933);
let _e10986 = ((_e9936.member * _e10974) + (_e9944.member * _e10979));
let _e10987 = ((_e9936.member_1 * _e10974) + (_e9944.member_1 * _e10979));
let _e10988 = ((_e9936.member_2 * _e10974) + (_e9944.member_2 * _e10979));
let _e10992 = select((_e9959.member + _e10986), _e9959.member, _e9957);
let _e10993 = select((_e9959.member_1 + _e10987), _e9959.member_1, _e9957);
let _e10994 = select((_e9959.member_2 + _e10988), _e9959.member_2, _e9957);
let _e11005 = (((_e10992 * _e10992) + (_e10993 * _e10993)) + (_e10994 * _e10994));
let _e11009 = (1f / sqrt(select(0f, _e11005, (_e11005 > 0f))));
let _e11010 = (_e10992 * _e11009);
let _e11011 = (_e10993 * _e11009);
let _e11012 = (_e10994 * _e11009);
let _e11013 = (_e575 - select(_e9970.member, (_e9970.member + _e10986), _e9957));
let _e11014 = (_e587 - select(_e9970.member_1, (_e9970.member_1 + _e10987), _e9957));
let _e11015 = (_e600 - select(_e9970.member_2, (_e9970.member_2 + _e10988), _e9957));
let _e11020 = (((_e11013 * _e11010) + (_e11014 * _e11011)) + (_e11015 * _e11012));
let _e11025 = (((_e11013 * _e613) + (_e11014 * _e626)) + (_e11015 * _e639));
let _e11030 = (((_e11010 * _e613) + (_e11011 * _e626)) + (_e11012 * _e639));
let _e11033 = ((_e11011 * _e639) - (_e11012 * _e626));
let _e11036 = ((_e11012 * _e613) - (_e11010 * _e639));
let _e11039 = ((_e11010 * _e626) - (_e11011 * _e613));
let _e11044 = (((_e11033 * _e11033) + (_e11036 * _e11036)) + (_e11039 * _e11039));
let _e11047 = (1f / select(1e-9f, _e11044, (_e11044 > 1e-9f)));
let _e11050 = ((_e11020 - (_e11030 * _e11025)) * _e11047);
let _e11053 = (((_e11030 * _e11020) - _e11025) * _e11047);
let _e11059 = select(0f, _e11050, (((_e11053 >= 0f) && (_e11053 < _e691)) && (_e11050 > 0f)));
let _e11061 = (_e10928 << bitcast<u32>(_e10688));
let _e11073 = (_e10744 + 1i);
if _e10754 {
phi_27494_ = (_e10704.member - 1i);
} else {
phi_27494_ = _e10753;
}
let _e11077 = phi_27494_;
let _e11079 = select(_e11073, 0i, (_e11073 < 0i));
let _e11080 = (_e11079 >= _e10704.member_1);
if _e11080 {
phi_27505_ = (_e10704.member_1 - 1i);
} else {
phi_27505_ = _e11079;
}
let _e11083 = phi_27505_;
let _e11087 = (((f32(_e11077) + 0.5f) * _e10709) - 0.5f);
let _e11091 = (((f32(_e11083) + 0.5f) * _e10709) - 0.5f);
if _e453 {
phi_27533_ = type_23(_e11083, _e11077);
} else {
phi_27533_ = type_23(_e11077, _e11083);
}
let _e11097 = phi_27533_;
if _e10793 {
phi_27584_ = 0u;
} else {
if (_e10687 == 1u) {
phi_27583_ = 0u;
} else {
if (_e10687 == 2u) {
phi_27582_ = _e10786;
} else {
phi_27582_ = select(_e10792, _e10789, (_e10687 == 3u));
}
let _e11105 = phi_27582_;
phi_27583_ = _e11105;
}
let _e11107 = phi_27583_;
phi_27584_ = _e11107;
}
let _e11109 = phi_27584_;
local_116 = (((bitcast<i32>(_e11109) + _e11097.member_1) * _e10783) + _e11097.member);
let _e11114 = local_116;
let _e11116 = select(_e10810, _e11114, (_e11114 < _e10810));
let _e11121 = global_6.member[bitcast<u32>(select(0i, _e11116, (_e11116 > 0i)))];
let _e11126 = (((((select(_e11087, _e11091, _e453) + 0.5f) / _e9917) * 2f) - 1f) * _e9925);
let _e11131 = ((1f - (((select(_e11091, _e11087, _e453) + 0.5f) / _e9918) * 2f)) * _e9933);
let _e11138 = ((_e9936.member * _e11126) + (_e9944.member * _e11131));
let _e11139 = ((_e9936.member_1 * _e11126) + (_e9944.member_1 * _e11131));
let _e11140 = ((_e9936.member_2 * _e11126) + (_e9944.member_2 * _e11131));
let _e11144 = select((_e9959.member + _e11138), _e9959.member, _e9957);
let _e11145 = select((_e9959.member_1 + _e11139), _e9959.member_1, _e9957);
let _e11146 = select((_e9959.member_2 + _e11140), _e9959.member_2, _e9957);
let _e11157 = (((_e11144 * _e11144) + (_e11145 * _e11145)) + (_e11146 * _e11146));
let _e11161 = (1f / sqrt(select(0f, _e11157, (_e11157 > 0f))));
let _e11162 = (_e11144 * _e11161);
let _e11163 = (_e11145 * _e11161);
let _e11164 = (_e11146 * _e11161);
let _e11165 = (_e575 - select(_e9970.member, (_e9970.member + _e11138), _e9957));
let _e11166 = (_e587 - select(_e9970.member_1, (_e9970.member_1 + _e11139), _e9957));
let _e11167 = (_e600 - select(_e9970.member_2, (_e9970.member_2 + _e11140), _e9957));
let _e11172 = (((_e11165 * _e11162) + (_e11166 * _e11163)) + (_e11167 * _e11164));
let _e11177 = (((_e11165 * _e613) + (_e11166 * _e626)) + (_e11167 * _e639));
let _e11182 = (((_e11162 * _e613) + (_e11163 * _e626)) + (_e11164 * _e639));
let _e11185 = ((_e11163 * _e639) - (_e11164 * _e626));
let _e11188 = ((_e11164 * _e613) - (_e11162 * _e639));
let _e11191 = ((_e11162 * _e626) - (_e11163 * _e613));
let _e11196 = (((_e11185 * _e11185) + (_e11188 * _e11188)) + (_e11191 * _e11191));
let _e11199 = (1f / select(1e-9f, _e11196, (_e11196 > 1e-9f)));
let _e11202 = ((_e11172 - (_e11182 * _e11177)) * _e11199);
let _e11205 = (((_e11182 * _e11172) - _e11177) * _e11199);
let _e11211 = select(0f, _e11202, (((_e11205 >= 0f) && (_e11205 < _e691)) && (_e11202 > 0f)));
let _e11213 = (_e11077 << bitcast<u32>(_e10688));
if _e10925 {
phi_28245_ = (_e10704.member - 1i);
} else {
phi_28245_ = _e10924;
}
let _e11228 = phi_28245_;
if _e11080 {
phi_28256_ = (_e10704.member_1 - 1i);
} else {
phi_28256_ = _e11079;
}
let _e11231 = phi_28256_;
let _e11235 = (((f32(_e11228) + 0.5f) * _e10709) - 0.5f);
let _e11239 = (((f32(_e11231) + 0.5f) * _e10709) - 0.5f);
if _e453 {
phi_28284_ = type_23(_e11231, _e11228);
} else {
phi_28284_ = type_23(_e11228, _e11231);
}
let _e11245 = phi_28284_;
if _e10793 {
phi_28335_ = 0u;
} else {
if (_e10687 == 1u) {
phi_28334_ = 0u;
} else {
if (_e10687 == 2u) {
phi_28333_ = _e10786;
} else {
phi_28333_ = select(_e10792, _e10789, (_e10687 == 3u));
}
let _e11253 = phi_28333_;
phi_28334_ = _e11253;
}
let _e11255 = phi_28334_;
phi_28335_ = _e11255;
}
let _e11257 = phi_28335_;
local_114 = (((bitcast<i32>(_e11257) + _e11245.member_1) * _e10783) + _e11245.member);
let _e11262 = local_114;
let _e11264 = select(_e10810, _e11262, (_e11262 < _e10810));
let _e11269 = global_6.member[bitcast<u32>(select(0i, _e11264, (_e11264 > 0i)))];
let _e11274 = (((((select(_e11235, _e11239, _e453) + 0.5f) / _e9917) * 2f) - 1f) * _e9925);
let _e11279 = ((1f - (((select(_e11239, _e11235, _e453) + 0.5f) / _e9918) * 2f)) * _e9933);
let _e11286 = ((_e9936.member * _e11274) + (_e9944.member * _e11279));
let _e11287 = ((_e9936.member_1 * _e11274) + (_e9944.member_1 * _e11279));
let _e11288 = ((_e9936.member_2 * _e11274) + (_e9944.member_2 * _e11279));
let _e11292 = select((_e9959.member + _e11286), _e9959.member, _e9957);
let _e11293 = select((_e9959.member_1 + _e11287), _e9959.member_1, _e9957);
let _e11294 = select((_e9959.member_2 + _e11288), _e9959.member_2, _e9957);
let _e11305 = (((_e11292 * _e11292) + (_e11293 * _e11293)) + (_e11294 * _e11294));
let _e11309 = (1f / sqrt(select(0f, _e11305, (_e11305 > 0f))));
let _e11310 = (_e11292 * _e11309);
let _e11311 = (_e11293 * _e11309);
let _e11312 = (_e11294 * _e11309);
let _e11313 = (_e575 - select(_e9970.member, (_e9970.member + _e11286), _e9957));
let _e11314 = (_e587 - select(_e9970.member_1, (_e9970.member_1 + _e11287), _e9957));
let _e11315 = (_e600 - select(_e9970.member_2, (_e9970.member_2 + _e11288), _e9957));
let _e11320 = (((_e11313 * _e11310) + (_e11314 * _e11311)) + (_e11315 * _e11312));
let _e11325 = (((_e11313 * _e613) + (_e11314 * _e626)) + (_e11315 * _e639));
let _e11330 = (((_e11310 * _e613) + (_e11311 * _e626)) + (_e11312 * _e639));
let _e11333 = ((_e11311 * _e639) - (_e11312 * _e626));
let _e11336 = ((_e11312 * _e613) - (_e11310 * _e639));
let _e11339 = ((_e11310 * _e626) - (_e11311 * _e613));
let _e11344 = (((_e11333 * _e11333) + (_e11336 * _e11336)) + (_e11339 * _e11339));
let _e11347 = (1f / select(1e-9f, _e11344, (_e11344 > 1e-9f)));
let _e11350 = ((_e11320 - (_e11330 * _e11325)) * _e11347);
let _e11353 = (((_e11330 * _e11320) - _e11325) * _e11347);
let _e11359 = select(0f, _e11350, (((_e11353 >= 0f) && (_e11353 < _e691)) && (_e11350 > 0f)));
let _e11361 = (_e11228 << bitcast<u32>(_e10688));
let _e11373 = select(((((1f - select(0f, (_e10749 * _e10750), (((select(select(_e766, _e923, (_e10909 >= _e692)), _e845, (_e10909 < _e298)) == _e10687) && (_e10907 > 0f)) && (_e10907 < _e10817)))) - select(0f, (_e10746 * _e10750), (((select(select(_e766, _e923, (_e11061 >= _e692)), _e845, (_e11061 < _e298)) == _e10687) && (_e11059 > 0f)) && (_e11059 < _e10969)))) - select(0f, (_e10749 * _e10748), (((select(select(_e766, _e923, (_e11213 >= _e692)), _e845, (_e11213 < _e298)) == _e10687) && (_e11211 > 0f)) && (_e11211 < _e11121)))) - select(0f, (_e10746 * _e10748), (((select(select(_e766, _e923, (_e11361 >= _e692)), _e845, (_e11361 < _e298)) == _e10687) && (_e11359 > 0f)) && (_e11359 < _e11269)))), 1f, _e10793);
if _e453 {
phi_29005_ = type_23(_e9822, _e9729);
} else {
phi_29005_ = type_23(_e9729, _e9822);
}
let _e11388 = phi_29005_;
let _e11391 = (_e9823 && (((_e10685 > 0f) && (_e10685 < _e9913)) && (bitcast<f32>((bitcast<u32>(_e11373) & 2147483647u)) > 1e-6f)));
let _e11394 = global_1.member.member_18.member;
let _e11395 = (((select(_e9848, (1f - _e9848), (_e9833 >= 0f)) - select(_e9867, (1f - _e9867), (_e9852 >= 0f))) * (1f / _e9830)) * _e11394);
let _e11399 = select(0f, (((((_e652 * _e10522.member) * ((1f + (_e10562 * (1f + (_e10562 * (0.5f + (_e10562 * (0.16666667f + (_e10562 * (0.041666668f + (_e10562 * (0.008333334f + (_e10562 * (0.001388889f + (_e10562 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10557 + 127i)) << bitcast<u32>(23i))))) * _e10519) * _e11373) * _e11395), _e11391);
let _e11400 = select(0f, (((((_e665 * _e10522.member_1) * ((1f + (_e10610 * (1f + (_e10610 * (0.5f + (_e10610 * (0.16666667f + (_e10610 * (0.041666668f + (_e10610 * (0.008333334f + (_e10610 * (0.001388889f + (_e10610 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10605 + 127i)) << bitcast<u32>(23i))))) * _e10519) * _e11373) * _e11395), _e11391);
let _e11401 = select(0f, (((((_e678 * _e10522.member_2) * ((1f + (_e10658 * (1f + (_e10658 * (0.5f + (_e10658 * (0.16666667f + (_e10658 * (0.041666668f + (_e10658 * (0.008333334f + (_e10658 * (0.001388889f + (_e10658 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10653 + 127i)) << bitcast<u32>(23i))))) * _e10519) * _e11373) * _e11395), _e11391);
let _e11405 = (bitcast<f32>((bitcast<u32>(_e11399) & 2147483647u)) >= 1073741800f);
let _e11406 = (1f / 1048576f);
let _e11409 = ((_e11399 * select(1f, _e11406, _e11405)) + 0.5f);
let _e11411 = select(-1073741800f, _e11409, (_e11409 > -1073741800f));
let _e11413 = select(1073741800f, _e11411, (_e11411 < 1073741800f));
let _e11420 = select(0i, select(select(i32(_e11413), i32(-2147483648), (_e11413 < -2147483600f)), 2147483647i, (_e11413 > 2147483500f)), (_e11413 == _e11413));
let _e11424 = (_e11420 - select(0i, 1i, (_e11413 < f32(_e11420))));
let _e11425 = select(0i, 20i, _e11405);
let _e11429 = (bitcast<u32>(_e11424) << bitcast<u32>((_e11425 & 31i)));
let _e11436 = bitcast<u32>(((_e11424 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11425) & 31i))));
let _e11440 = (bitcast<f32>((bitcast<u32>(_e11400) & 2147483647u)) >= 1073741800f);
let _e11443 = ((_e11400 * select(1f, _e11406, _e11440)) + 0.5f);
let _e11445 = select(-1073741800f, _e11443, (_e11443 > -1073741800f));
let _e11447 = select(1073741800f, _e11445, (_e11445 < 1073741800f));
let _e11454 = select(0i, select(select(i32(_e11447), i32(-2147483648), (_e11447 < -2147483600f)), 2147483647i, (_e11447 > 2147483500f)), (_e11447 == _e11447));
let _e11458 = (_e11454 - select(0i, 1i, (_e11447 < f32(_e11454))));
let _e11459 = select(0i, 20i, _e11440);
let _e11463 = (bitcast<u32>(_e11458) << bitcast<u32>((_e11459 & 31i)));
let _e11470 = bitcast<u32>(((_e11458 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11459) & 31i))));
let _e11474 = (bitcast<f32>((bitcast<u32>(_e11401) & 2147483647u)) >= 1073741800f);
let _e11477 = ((_e11401 * select(1f, _e11406, _e11474)) + 0.5f);
let _e11479 = select(-1073741800f, _e11477, (_e11477 > -1073741800f));
let _e11481 = select(1073741800f, _e11479, (_e11479 < 1073741800f));
let _e11488 = select(0i, select(select(i32(_e11481), i32(-2147483648), (_e11481 < -2147483600f)), 2147483647i, (_e11481 > 2147483500f)), (_e11481 == _e11481));
let _e11492 = (_e11488 - select(0i, 1i, (_e11481 < f32(_e11488))));
let _e11493 = select(0i, 20i, _e11474);
let _e11497 = (bitcast<u32>(_e11492) << bitcast<u32>((_e11493 & 31i)));
let _e11504 = bitcast<u32>(((_e11492 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11493) & 31i))));
let _e11509 = bitcast<i32>(bitcast<u32>((((_e11388.member_1 * _e931) + _e11388.member) * 6i)));
if ((_e11429 | _e11436) == 0u) {
} else {
let _e11512 = bitcast<u32>(_e11509);
if (_e11512 < _e270) {
let _e11516 = atomicAdd((&global_8.member[_e11512]), _e11429);
phi_29238_ = _e11516;
} else {
phi_29238_ = 0u;
}
let _e11518 = phi_29238_;
let _e11522 = (_e11436 + select(0u, 1u, ((_e11518 + _e11429) < _e11429)));
if (_e11522 == 0u) {
} else {
let _e11524 = (_e11512 + 1u);
if (_e11524 < _e270) {
let _e11528 = atomicAdd((&global_8.member[_e11524]), _e11522);
}
}
}
if ((_e11463 | _e11470) == 0u) {
} else {
let _e11532 = bitcast<u32>((_e11509 + 2i));
if (_e11532 < _e270) {
let _e11536 = atomicAdd((&global_8.member[_e11532]), _e11463);
phi_29268_ = _e11536;
} else {
phi_29268_ = 0u;
}
let _e11538 = phi_29268_;
let _e11542 = (_e11470 + select(0u, 1u, ((_e11538 + _e11463) < _e11463)));
if (_e11542 == 0u) {
} else {
let _e11544 = (_e11532 + 1u);
if (_e11544 < _e270) {
let _e11548 = atomicAdd((&global_8.member[_e11544]), _e11542);
}
}
}
if ((_e11497 | _e11504) == 0u) {
} else {
let _e11552 = bitcast<u32>((_e11509 + 4i));
if (_e11552 < _e270) {
let _e11556 = atomicAdd((&global_8.member[_e11552]), _e11497);
phi_29298_ = _e11556;
} else {
phi_29298_ = 0u;
}
let _e11558 = phi_29298_;
let _e11562 = (_e11504 + select(0u, 1u, ((_e11558 + _e11497) < _e11497)));
if (_e11562 == 0u) {
} else {
let _e11564 = (_e11552 + 1u);
if (_e11564 < _e270) {
let _e11568 = atomicAdd((&global_8.member[_e11564]), _e11562);
}
}
}
phi_24514_ = (_e9820 + 1i);
} else {
phi_24514_ = i32();
}
let _e11571 = phi_24514_;
continue;
continuing {
phi_24513_ = _e11571;
break if !(_e9823);
}
}
phi_24360_ = (_e9726 + 1i);
} else {
phi_24360_ = i32();
}
let _e11575 = phi_24360_;
continue;
continuing {
phi_24359_ = _e11575;
break if !(_e9727);
}
}
} else {
phi_29343_ = 0i;
loop {
let _e11578 = phi_29343_;
let _e11579 = (_e11578 < 16i);
if _e11579 {
let _e11581 = (_e976 + (_e11578 & 15i));
let _e11583 = (f32(_e11581) + 0.5f);
let _e11585 = ((_e11583 * 1f) - 0.5f);
let _e11589 = (-(((_e416 * _e11585) + _e442)) / _e429);
let _e11596 = bitcast<f32>((bitcast<u32>(((_e466 * _e11585) + ((_e479 * _e11589) + _e492))) & 2147483647u));
let _e11603 = bitcast<f32>((bitcast<u32>(((_e505 * _e11585) + ((_e518 * _e11589) + _e531))) & 2147483647u));
let _e11607 = (((0.5f * (_e11596 + _e11603)) / _e534) + _e717);
let _e11608 = (1f / 1f);
let _e11616 = ((((_e11589 + _e11607) + 0.5f) * _e11608) - 0.5f);
let _e11617 = f32(_e8548);
let _e11618 = f32(_e8546);
let _e11619 = (_e11617 - 1f);
let _e11621 = select(_e11619, _e11616, (_e11616 > _e11619));
let _e11623 = select(_e11618, _e11621, (_e11621 < _e11618));
let _e11630 = select(0i, select(select(i32(_e11623), i32(-2147483648), (_e11623 < -2147483600f)), 2147483647i, (_e11623 > 2147483500f)), (_e11623 == _e11623));
let _e11635 = (((((_e11589 - _e11607) + 0.5f) * _e11608) - 0.5f) + 1f);
let _e11636 = (_e11618 + 1f);
let _e11638 = select(_e11617, _e11635, (_e11635 > _e11617));
let _e11640 = select(_e11636, _e11638, (_e11638 < _e11636));
let _e11647 = select(0i, select(select(i32(_e11640), i32(-2147483648), (_e11640 < -2147483600f)), 2147483647i, (_e11640 > 2147483500f)), (_e11640 == _e11640));
let _e11658 = ((1e-4f * 1f) * _e534);
let _e11660 = select(_e11603, _e11596, (_e11596 > _e11603));
let _e11662 = select(_e11658, _e11660, (_e11660 > _e11658));
let _e11664 = select(_e11603, _e11596, (_e11596 < _e11603));
let _e11666 = select(_e11658, _e11664, (_e11664 > _e11658));
let _e11668 = (0.5f * (_e11662 + _e11666));
let _e11669 = (0.5f / _e11666);
let _e11670 = (1f / _e11662);
phi_29497_ = 0i;
loop {
let _e11672 = phi_29497_;
let _e11674 = (((_e11647 - select(0i, 1i, (_e11640 < f32(_e11647)))) + (_e11578 >> bitcast<u32>(4u))) + bitcast<i32>(_e11672));
let _e11675 = (_e11674 <= select(-1i, (_e11630 - select(0i, 1i, (_e11623 < f32(_e11630)))), (_e11581 <= _e980)));
if _e11675 {
let _e11677 = (f32(_e11674) + 0.5f);
let _e11681 = ((((_e11677 * 1f) - 0.5f) - _e11589) * _e534);
let _e11682 = (_e534 * 1f);
let _e11684 = (0.5f * _e11682);
let _e11685 = (_e11681 + _e11684);
let _e11686 = -(_e11685);
let _e11689 = (_e11668 - select(_e11686, _e11685, (_e11685 > _e11686)));
let _e11691 = select(0f, _e11689, (_e11689 > 0f));
let _e11693 = select(_e11666, _e11691, (_e11691 < _e11666));
let _e11696 = (_e11689 - _e11666);
let _e11700 = (((_e11693 * (_e11693 * _e11669)) + select(0f, _e11696, (_e11696 > 0f))) * _e11670);
let _e11704 = (_e11681 - _e11684);
let _e11705 = -(_e11704);
let _e11708 = (_e11668 - select(_e11705, _e11704, (_e11704 > _e11705)));
let _e11710 = select(0f, _e11708, (_e11708 > 0f));
let _e11712 = select(_e11666, _e11710, (_e11710 < _e11666));
let _e11715 = (_e11708 - _e11666);
let _e11719 = (((_e11712 * (_e11712 * _e11669)) + select(0f, _e11715, (_e11715 > 0f))) * _e11670);
if _e453 {
phi_29602_ = type_23(_e11674, _e11581);
} else {
phi_29602_ = type_23(_e11581, _e11674);
}
let _e11728 = phi_29602_;
let _e11732 = bitcast<i32>((_e927 * _e930));
local_112 = _e11732;
local_113 = ((_e11728.member_1 * _e931) + _e11728.member);
let _e11735 = local_112;
let _e11736 = local_113;
let _e11737 = (_e11735 + _e11736);
let _e11739 = (bitcast<i32>(_e259) - 1i);
let _e11741 = select(_e11739, _e11737, (_e11737 < _e11739));
let _e11746 = global_5.member[bitcast<u32>(select(0i, _e11741, (_e11741 > 0i)))];
let _e11747 = local_112;
let _e11749 = local_113;
let _e11750 = ((2i * _e11747) + _e11749);
let _e11752 = select(_e11739, _e11750, (_e11750 < _e11739));
let _e11757 = global_5.member[bitcast<u32>(select(0i, _e11752, (_e11752 > 0i)))];
let _e11758 = local_113;
let _e11760 = select(_e11739, _e11758, (_e11758 < _e11739));
let _e11765 = global_5.member[bitcast<u32>(select(0i, _e11760, (_e11760 > 0i)))];
let _e11766 = local_113;
let _e11769 = f32(_e931);
let _e11770 = f32(_e932);
let _e11777 = global_1.member.member_2.member;
let _e11778 = (((((f32(_e11728.member) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e11785 = global_1.member.member_2.member_1;
let _e11786 = ((1f - (((f32(_e11728.member_1) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e11788 = global_1.member.member_3;
let _e11796 = global_1.member.member_4;
let _e11803 = ((_e11788.member * _e11778) + (_e11796.member * _e11786));
let _e11804 = ((_e11788.member_1 * _e11778) + (_e11796.member_1 * _e11786));
let _e11805 = ((_e11788.member_2 * _e11778) + (_e11796.member_2 * _e11786));
let _e11808 = global_1.member.member_2.member_3;
let _e11809 = (_e11808 != 0u);
let _e11811 = global_1.member.member_5;
let _e11818 = select((_e11811.member + _e11803), _e11811.member, _e11809);
let _e11819 = select((_e11811.member_1 + _e11804), _e11811.member_1, _e11809);
let _e11820 = select((_e11811.member_2 + _e11805), _e11811.member_2, _e11809);
let _e11822 = global_1.member.member_6;
let _e11829 = select(_e11822.member, (_e11822.member + _e11803), _e11809);
let _e11830 = select(_e11822.member_1, (_e11822.member_1 + _e11804), _e11809);
let _e11831 = select(_e11822.member_2, (_e11822.member_2 + _e11805), _e11809);
let _e11836 = (((_e11818 * _e11818) + (_e11819 * _e11819)) + (_e11820 * _e11820));
let _e11839 = sqrt(select(0f, _e11836, (_e11836 > 0f)));
let _e11840 = (1f / _e11839);
let _e11841 = (_e11818 * _e11840);
let _e11842 = (_e11819 * _e11840);
let _e11843 = (_e11820 * _e11840);
let _e11844 = (_e575 - _e11829);
let _e11845 = (_e587 - _e11830);
let _e11846 = (_e600 - _e11831);
let _e11851 = (((_e11844 * _e11841) + (_e11845 * _e11842)) + (_e11846 * _e11843));
let _e11856 = (((_e11844 * _e613) + (_e11845 * _e626)) + (_e11846 * _e639));
let _e11861 = (((_e11841 * _e613) + (_e11842 * _e626)) + (_e11843 * _e639));
let _e11864 = ((_e11842 * _e639) - (_e11843 * _e626));
let _e11867 = ((_e11843 * _e613) - (_e11841 * _e639));
let _e11870 = ((_e11841 * _e626) - (_e11842 * _e613));
let _e11875 = (((_e11864 * _e11864) + (_e11867 * _e11867)) + (_e11870 * _e11870));
let _e11878 = (1f / select(1e-9f, _e11875, (_e11875 > 1e-9f)));
let _e11881 = ((_e11851 - (_e11861 * _e11856)) * _e11878);
let _e11884 = (((_e11861 * _e11851) - _e11856) * _e11878);
let _e11890 = -(_e11861);
let _e11893 = global_1.member.member_13.member_2;
let _e11894 = (_e11893 * _e11893);
let _e11898 = ((1f + _e11894) - ((2f * _e11893) * _e11890));
let _e11900 = select(1e-9f, _e11898, (_e11898 > 1e-9f));
let _e11912 = global_1.member.member_13.member_3;
if (_e11912 == 2u) {
let _e11917 = (0.5f - (0.5f * _e11890));
let _e11919 = select(0f, _e11917, (_e11917 > 0f));
let _e11923 = (sqrt(select(0f, _e11919, (_e11919 > 0f))) * 255f);
let _e11924 = (255f - 1f);
let _e11926 = select(0f, _e11923, (_e11923 > 0f));
let _e11928 = select(_e11924, _e11926, (_e11926 < _e11924));
let _e11935 = select(0i, select(select(i32(_e11928), i32(-2147483648), (_e11928 < -2147483600f)), 2147483647i, (_e11928 > 2147483500f)), (_e11928 == _e11928));
let _e11939 = (_e11935 - select(0i, 1i, (_e11928 < f32(_e11935))));
let _e11942 = global_1.member.member_13.member_11;
let _e11943 = bitcast<i32>(_e11942);
let _e11944 = (_e11943 + _e11939);
let _e11946 = (bitcast<i32>(_e265) - 1i);
let _e11948 = select(_e11946, _e11944, (_e11944 < _e11946));
let _e11953 = global_2.member[bitcast<u32>(select(0i, _e11948, (_e11948 > 0i)))];
let _e11955 = (_e11943 + (_e11939 + 1i));
let _e11957 = select(_e11946, _e11955, (_e11955 < _e11946));
let _e11962 = global_2.member[bitcast<u32>(select(0i, _e11957, (_e11957 > 0i)))];
phi_30029_ = (_e11953 + ((_e11962 - _e11953) * (_e11923 - f32(_e11939))));
} else {
phi_30029_ = select(((1f - _e11894) / (_e11900 * sqrt(select(0f, _e11900, (_e11900 > 0f))))), (0.75f * (1f + (_e11890 * _e11890))), (_e11912 == 1u));
}
let _e11969 = phi_30029_;
let _e11975 = global_1.member.member_12.member_12;
let _e11978 = global_1.member.member_12.member_4;
let _e11981 = global_1.member.member_12.member_13;
let _e11987 = global_1.member.member.member;
let _e11989 = (_e11884 / _e691);
local_109 = bitcast<i32>((_e11975 + (_e11978 * _e11981)));
local_110 = _e281;
local_111 = bitcast<i32>(_e11987);
let _e11992 = global_1.member.member_13.member_6;
let _e11993 = f32(_e11992);
let _e11995 = select(0f, _e11989, (_e11989 > 0f));
let _e11998 = (select(1f, _e11995, (_e11995 < 1f)) * _e11993);
let _e11999 = (_e11993 - 1f);
let _e12001 = select(0f, _e11999, (_e11999 > 0f));
let _e12003 = select(0f, _e11998, (_e11998 > 0f));
let _e12005 = select(_e12001, _e12003, (_e12003 < _e12001));
let _e12012 = select(0i, select(select(i32(_e12005), i32(-2147483648), (_e12005 < -2147483600f)), 2147483647i, (_e12005 > 2147483500f)), (_e12005 == _e12005));
let _e12016 = (_e12012 - select(0i, 1i, (_e12005 < f32(_e12012))));
if (_e12016 > 0i) {
let _e12019 = local_109;
let _e12020 = local_111;
let _e12023 = local_110;
let _e12024 = ((_e12019 + ((_e12016 - 1i) * _e12020)) + _e12023);
let _e12026 = (bitcast<i32>(_e268) - 1i);
let _e12028 = select(_e12026, _e12024, (_e12024 < _e12026));
let _e12033 = global_7.member[bitcast<u32>(select(0i, _e12028, (_e12028 > 0i)))];
phi_30135_ = _e12033;
} else {
phi_30135_ = 0f;
}
let _e12035 = phi_30135_;
let _e12036 = local_109;
let _e12037 = local_111;
let _e12040 = local_110;
let _e12041 = ((_e12036 + (_e12016 * _e12037)) + _e12040);
let _e12043 = (bitcast<i32>(_e268) - 1i);
let _e12045 = select(_e12043, _e12041, (_e12041 < _e12043));
let _e12050 = global_7.member[bitcast<u32>(select(0i, _e12045, (_e12045 > 0i)))];
let _e12057 = (_e11757 - _e11746);
let _e12060 = ((_e11881 - _e11746) / select(1e-9f, _e12057, (_e12057 > 1e-9f)));
local_106 = 0i;
local_107 = _e11766;
local_108 = _e11732;
let _e12062 = select(0f, _e12060, (_e12060 > 0f));
let _e12065 = (select(1f, _e12062, (_e12062 < 1f)) * _e11993);
let _e12067 = select(0f, _e12065, (_e12065 > 0f));
let _e12069 = select(_e12001, _e12067, (_e12067 < _e12001));
let _e12076 = select(0i, select(select(i32(_e12069), i32(-2147483648), (_e12069 < -2147483600f)), 2147483647i, (_e12069 > 2147483500f)), (_e12069 == _e12069));
let _e12080 = (_e12076 - select(0i, 1i, (_e12069 < f32(_e12076))));
if (_e12080 > 0i) {
let _e12083 = local_106;
let _e12084 = local_108;
let _e12087 = local_107;
let _e12088 = ((_e12083 + ((_e12080 - 1i) * _e12084)) + _e12087);
let _e12090 = select(_e12043, _e12088, (_e12088 < _e12043));
let _e12095 = global_7.member[bitcast<u32>(select(0i, _e12090, (_e12090 > 0i)))];
phi_30262_ = _e12095;
} else {
phi_30262_ = 0f;
}
let _e12097 = phi_30262_;
let _e12098 = local_106;
let _e12099 = local_108;
let _e12102 = local_107;
let _e12103 = ((_e12098 + (_e12080 * _e12099)) + _e12102);
let _e12105 = select(_e12043, _e12103, (_e12103 < _e12043));
let _e12110 = global_7.member[bitcast<u32>(select(0i, _e12105, (_e12105 > 0i)))];
let _e12116 = ((_e12035 + ((_e12050 - _e12035) * (_e11998 - f32(_e12016)))) + (_e12097 + ((_e12110 - _e12097) * (_e12065 - f32(_e12080)))));
let _e12125 = global_1.member.member_13.member_7;
let _e12126 = bitcast<i32>(_e12125);
let _e12129 = global_1.member.member_13.member_8;
let _e12130 = bitcast<i32>(_e12129);
let _e12133 = global_1.member.member_13.member_9;
let _e12134 = bitcast<i32>(_e12133);
let _e12137 = global_1.member.member_13.member_4;
let _e12143 = global_1.member.member_13.member_5;
let _e12147 = f32(_e12126);
let _e12152 = (((((_e11829 + (_e11841 * _e11881)) - _e12137.member) / (_e12143.member - _e12137.member)) * _e12147) - 0.5f);
let _e12153 = (_e12147 - 1f);
let _e12155 = select(0f, _e12152, (_e12152 > 0f));
let _e12157 = select(_e12153, _e12155, (_e12155 < _e12153));
let _e12158 = f32(_e12130);
let _e12163 = (((((_e11830 + (_e11842 * _e11881)) - _e12137.member_1) / (_e12143.member_1 - _e12137.member_1)) * _e12158) - 0.5f);
let _e12164 = (_e12158 - 1f);
let _e12166 = select(0f, _e12163, (_e12163 > 0f));
let _e12168 = select(_e12164, _e12166, (_e12166 < _e12164));
let _e12169 = f32(_e12134);
let _e12174 = (((((_e11831 + (_e11843 * _e11881)) - _e12137.member_2) / (_e12143.member_2 - _e12137.member_2)) * _e12169) - 0.5f);
let _e12175 = (_e12169 - 1f);
let _e12177 = select(0f, _e12174, (_e12174 > 0f));
let _e12179 = select(_e12175, _e12177, (_e12177 < _e12175));
let _e12181 = select(0f, _e12157, (_e12157 > 0f));
let _e12183 = select(1e6f, _e12181, (_e12181 < 1e6f));
let _e12190 = select(0i, select(select(i32(_e12183), i32(-2147483648), (_e12183 < -2147483600f)), 2147483647i, (_e12183 > 2147483500f)), (_e12183 == _e12183));
let _e12194 = (_e12190 - select(0i, 1i, (_e12183 < f32(_e12190))));
let _e12196 = select(0f, _e12168, (_e12168 > 0f));
let _e12198 = select(1e6f, _e12196, (_e12196 < 1e6f));
let _e12205 = select(0i, select(select(i32(_e12198), i32(-2147483648), (_e12198 < -2147483600f)), 2147483647i, (_e12198 > 2147483500f)), (_e12198 == _e12198));
let _e12209 = (_e12205 - select(0i, 1i, (_e12198 < f32(_e12205))));
let _e12211 = select(0f, _e12179, (_e12179 > 0f));
let _e12213 = select(1e6f, _e12211, (_e12211 < 1e6f));
let _e12220 = select(0i, select(select(i32(_e12213), i32(-2147483648), (_e12213 < -2147483600f)), 2147483647i, (_e12213 > 2147483500f)), (_e12213 == _e12213));
let _e12224 = (_e12220 - select(0i, 1i, (_e12213 < f32(_e12220))));
let _e12228 = (_e12168 - f32(_e12209));
let _e12230 = (_e12179 - f32(_e12224));
local_104 = (_e12157 - f32(_e12194));
let _e12231 = (_e12194 + 1i);
let _e12233 = select(_e12231, 0i, (_e12231 < 0i));
if (_e12233 >= _e12126) {
phi_30410_ = (_e12126 - 1i);
} else {
phi_30410_ = _e12233;
}
let _e12237 = phi_30410_;
local_105 = (_e12237 - _e12194);
let _e12239 = (_e12209 + 1i);
let _e12241 = select(_e12239, 0i, (_e12239 < 0i));
if (_e12241 >= _e12130) {
phi_30423_ = (_e12130 - 1i);
} else {
phi_30423_ = _e12241;
}
let _e12245 = phi_30423_;
let _e12247 = ((_e12245 - _e12209) * _e12126);
let _e12248 = (_e12224 + 1i);
let _e12250 = select(_e12248, 0i, (_e12248 < 0i));
if (_e12250 >= _e12134) {
phi_30437_ = (_e12134 - 1i);
} else {
phi_30437_ = _e12250;
}
let _e12254 = phi_30437_;
let _e12260 = global_1.member.member_13.member_10;
let _e12266 = ((bitcast<i32>(_e12260) + (((_e12224 * _e12130) + _e12209) * _e12126)) + _e12194);
let _e12268 = (bitcast<i32>(_e265) - 1i);
let _e12270 = select(_e12268, _e12266, (_e12266 < _e12268));
let _e12275 = global_2.member[bitcast<u32>(select(0i, _e12270, (_e12270 > 0i)))];
let _e12276 = local_104;
let _e12279 = local_105;
let _e12280 = (_e12266 + _e12279);
let _e12282 = select(_e12268, _e12280, (_e12280 < _e12268));
let _e12287 = global_2.member[bitcast<u32>(select(0i, _e12282, (_e12282 > 0i)))];
let _e12288 = local_104;
let _e12291 = (1f - _e12228);
let _e12293 = (_e12266 + _e12247);
let _e12295 = select(_e12268, _e12293, (_e12293 < _e12268));
let _e12300 = global_2.member[bitcast<u32>(select(0i, _e12295, (_e12295 > 0i)))];
let _e12301 = local_104;
let _e12304 = local_105;
let _e12305 = (_e12293 + _e12304);
let _e12307 = select(_e12268, _e12305, (_e12305 < _e12268));
let _e12312 = global_2.member[bitcast<u32>(select(0i, _e12307, (_e12307 > 0i)))];
let _e12313 = local_104;
let _e12318 = (_e12266 + (((_e12254 - _e12224) * _e12126) * _e12130));
let _e12320 = select(_e12268, _e12318, (_e12318 < _e12268));
let _e12325 = global_2.member[bitcast<u32>(select(0i, _e12320, (_e12320 > 0i)))];
let _e12326 = local_104;
let _e12329 = local_105;
let _e12330 = (_e12318 + _e12329);
let _e12332 = select(_e12268, _e12330, (_e12330 < _e12268));
let _e12337 = global_2.member[bitcast<u32>(select(0i, _e12332, (_e12332 > 0i)))];
let _e12338 = local_104;
let _e12342 = (_e12318 + _e12247);
let _e12344 = select(_e12268, _e12342, (_e12342 < _e12268));
let _e12349 = global_2.member[bitcast<u32>(select(0i, _e12344, (_e12344 > 0i)))];
let _e12350 = local_104;
let _e12353 = local_105;
let _e12354 = (_e12342 + _e12353);
let _e12356 = select(_e12268, _e12354, (_e12354 < _e12268));
let _e12361 = global_2.member[bitcast<u32>(select(0i, _e12356, (_e12356 > 0i)))];
let _e12362 = local_104;
let _e12371 = ((_e11839 * (_e11969 * (0.25f / 3.1415927f))) * ((((((_e12275 * (1f - _e12276)) + (_e12287 * _e12288)) * _e12291) + (((_e12300 * (1f - _e12301)) + (_e12312 * _e12313)) * _e12228)) * (1f - _e12230)) + (((((_e12325 * (1f - _e12326)) + (_e12337 * _e12338)) * _e12291) + (((_e12349 * (1f - _e12350)) + (_e12361 * _e12362)) * _e12228)) * _e12230)));
let _e12374 = global_1.member.member_13.member_1;
let _e12383 = global_1.member.member_13.member;
let _e12388 = -((_e12383.member * _e12116));
let _e12390 = select(-87f, _e12388, (_e12388 > -87f));
let _e12392 = select(88f, _e12390, (_e12390 < 88f));
let _e12394 = ((_e12392 * 1.442695f) + 0.5f);
let _e12396 = select(-127f, _e12394, (_e12394 > -127f));
let _e12398 = select(128f, _e12396, (_e12396 < 128f));
let _e12405 = select(0i, select(select(i32(_e12398), i32(-2147483648), (_e12398 < -2147483600f)), 2147483647i, (_e12398 > 2147483500f)), (_e12398 == _e12398));
let _e12409 = (_e12405 - select(0i, 1i, (_e12398 < f32(_e12405))));
let _e12410 = f32(_e12409);
let _e12414 = ((_e12392 - (_e12410 * 0.6933594f)) - (_e12410 * -2.1219444e-4f));
let _e12436 = -((_e12383.member_1 * _e12116));
let _e12438 = select(-87f, _e12436, (_e12436 > -87f));
let _e12440 = select(88f, _e12438, (_e12438 < 88f));
let _e12442 = ((_e12440 * 1.442695f) + 0.5f);
let _e12444 = select(-127f, _e12442, (_e12442 > -127f));
let _e12446 = select(128f, _e12444, (_e12444 < 128f));
let _e12453 = select(0i, select(select(i32(_e12446), i32(-2147483648), (_e12446 < -2147483600f)), 2147483647i, (_e12446 > 2147483500f)), (_e12446 == _e12446));
let _e12457 = (_e12453 - select(0i, 1i, (_e12446 < f32(_e12453))));
let _e12458 = f32(_e12457);
let _e12462 = ((_e12440 - (_e12458 * 0.6933594f)) - (_e12458 * -2.1219444e-4f));
let _e12484 = -((_e12383.member_2 * _e12116));
let _e12486 = select(-87f, _e12484, (_e12484 > -87f));
let _e12488 = select(88f, _e12486, (_e12486 < 88f));
let _e12490 = ((_e12488 * 1.442695f) + 0.5f);
let _e12492 = select(-127f, _e12490, (_e12490 > -127f));
let _e12494 = select(128f, _e12492, (_e12492 < 128f));
let _e12501 = select(0i, select(select(i32(_e12494), i32(-2147483648), (_e12494 < -2147483600f)), 2147483647i, (_e12494 > 2147483500f)), (_e12494 == _e12494));
let _e12505 = (_e12501 - select(0i, 1i, (_e12494 < f32(_e12501))));
let _e12506 = f32(_e12505);
let _e12510 = ((_e12488 - (_e12506 * 0.6933594f)) - (_e12506 * -2.1219444e-4f));
let _e12537 = select(0f, _e11881, (((_e11884 >= 0f) && (_e11884 < _e691)) && (_e11881 > 0f)));
if _e453 {
phi_30896_ = type_23(_e7211, _e7210);
} else {
phi_30896_ = type_23(_e7210, _e7211);
}
let _e12541 = phi_30896_;
let _e12546 = f32((1i << bitcast<u32>(_e7199)));
let _e12547 = (1f / _e12546);
let _e12549 = ((_e11583 * _e12547) - 0.5f);
let _e12551 = ((_e11677 * _e12547) - 0.5f);
let _e12553 = select(-1f, _e12549, (_e12549 > -1f));
let _e12555 = select(1e6f, _e12553, (_e12553 < 1e6f));
let _e12562 = select(0i, select(select(i32(_e12555), i32(-2147483648), (_e12555 < -2147483600f)), 2147483647i, (_e12555 > 2147483500f)), (_e12555 == _e12555));
let _e12566 = (_e12562 - select(0i, 1i, (_e12555 < f32(_e12562))));
let _e12568 = select(-1f, _e12551, (_e12551 > -1f));
let _e12570 = select(1e6f, _e12568, (_e12568 < 1e6f));
let _e12577 = select(0i, select(select(i32(_e12570), i32(-2147483648), (_e12570 < -2147483600f)), 2147483647i, (_e12570 > 2147483500f)), (_e12570 == _e12570));
let _e12581 = (_e12577 - select(0i, 1i, (_e12570 < f32(_e12577))));
let _e12583 = (_e12549 - f32(_e12566));
let _e12585 = (_e12551 - f32(_e12581));
let _e12586 = (1f - _e12583);
let _e12587 = (1f - _e12585);
let _e12590 = select(_e12566, 0i, (_e12566 < 0i));
let _e12591 = (_e12590 >= _e12541.member);
if _e12591 {
phi_30974_ = (_e12541.member - 1i);
} else {
phi_30974_ = _e12590;
}
let _e12594 = phi_30974_;
let _e12596 = select(_e12581, 0i, (_e12581 < 0i));
let _e12597 = (_e12596 >= _e12541.member_1);
if _e12597 {
phi_30985_ = (_e12541.member_1 - 1i);
} else {
phi_30985_ = _e12596;
}
let _e12600 = phi_30985_;
let _e12604 = (((f32(_e12594) + 0.5f) * _e12546) - 0.5f);
let _e12608 = (((f32(_e12600) + 0.5f) * _e12546) - 0.5f);
if _e453 {
phi_31013_ = type_23(_e12600, _e12594);
} else {
phi_31013_ = type_23(_e12594, _e12600);
}
let _e12614 = phi_31013_;
let _e12620 = bitcast<i32>(((_e927 + 1u) >> bitcast<u32>(1u)));
let _e12623 = global_1.member.member_18.member_6;
let _e12626 = global_1.member.member_18.member_7;
let _e12629 = global_1.member.member_18.member_8;
if _e982 {
phi_31064_ = 0u;
} else {
if (_e766 == 1u) {
phi_31063_ = 0u;
} else {
if (_e766 == 2u) {
phi_31062_ = _e12623;
} else {
phi_31062_ = select(_e12629, _e12626, (_e766 == 3u));
}
let _e12635 = phi_31062_;
phi_31063_ = _e12635;
}
let _e12637 = phi_31063_;
phi_31064_ = _e12637;
}
let _e12639 = phi_31064_;
local_102 = (((bitcast<i32>(_e12639) + _e12614.member_1) * _e12620) + _e12614.member);
let _e12644 = local_102;
let _e12646 = (bitcast<i32>(_e262) - 1i);
let _e12648 = select(_e12646, _e12644, (_e12644 < _e12646));
let _e12653 = global_6.member[bitcast<u32>(select(0i, _e12648, (_e12648 > 0i)))];
let _e12658 = (((((select(_e12604, _e12608, _e453) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e12663 = ((1f - (((select(_e12608, _e12604, _e453) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e12670 = ((_e11788.member * _e12658) + (_e11796.member * _e12663));
let _e12671 = ((_e11788.member_1 * _e12658) + (_e11796.member_1 * _e12663));
let _e12672 = ((_e11788.member_2 * _e12658) + (_e11796.member_2 * _e12663));
let _e12676 = select((_e11811.member + _e12670), _e11811.member, _e11809);
let _e12677 = select((_e11811.member_1 + _e12671), _e11811.member_1, _e11809);
let _e12678 = select((_e11811.member_2 + _e12672), _e11811.member_2, _e11809);
let _e12689 = (((_e12676 * _e12676) + (_e12677 * _e12677)) + (_e12678 * _e12678));
let _e12693 = (1f / sqrt(select(0f, _e12689, (_e12689 > 0f))));
let _e12694 = (_e12676 * _e12693);
let _e12695 = (_e12677 * _e12693);
let _e12696 = (_e12678 * _e12693);
let _e12697 = (_e575 - select(_e11822.member, (_e11822.member + _e12670), _e11809));
let _e12698 = (_e587 - select(_e11822.member_1, (_e11822.member_1 + _e12671), _e11809));
let _e12699 = (_e600 - select(_e11822.member_2, (_e11822.member_2 + _e12672), _e11809));
let _e12704 = (((_e12697 * _e12694) + (_e12698 * _e12695)) + (_e12699 * _e12696));
let _e12709 = (((_e12697 * _e613) + (_e12698 * _e626)) + (_e12699 * _e639));
let _e12714 = (((_e12694 * _e613) + (_e12695 * _e626)) + (_e12696 * _e639));
let _e12717 = ((_e12695 * _e639) - (_e12696 * _e626));
let _e12720 = ((_e12696 * _e613) - (_e12694 * _e639));
let _e12723 = ((_e12694 * _e626) - (_e12695 * _e613));
let _e12728 = (((_e12717 * _e12717) + (_e12720 * _e12720)) + (_e12723 * _e12723));
let _e12731 = (1f / select(1e-9f, _e12728, (_e12728 > 1e-9f)));
let _e12734 = ((_e12704 - (_e12714 * _e12709)) * _e12731);
let _e12737 = (((_e12714 * _e12704) - _e12709) * _e12731);
let _e12743 = select(0f, _e12734, (((_e12737 >= 0f) && (_e12737 < _e691)) && (_e12734 > 0f)));
let _e12745 = (_e12594 << bitcast<u32>(_e7199));
let _e12757 = (_e12566 + 1i);
let _e12760 = select(_e12757, 0i, (_e12757 < 0i));
let _e12761 = (_e12760 >= _e12541.member);
if _e12761 {
phi_31725_ = (_e12541.member - 1i);
} else {
phi_31725_ = _e12760;
}
let _e12764 = phi_31725_;
if _e12597 {
phi_31736_ = (_e12541.member_1 - 1i);
} else {
phi_31736_ = _e12596;
}
let _e12767 = phi_31736_;
let _e12771 = (((f32(_e12764) + 0.5f) * _e12546) - 0.5f);
let _e12775 = (((f32(_e12767) + 0.5f) * _e12546) - 0.5f);
if _e453 {
phi_31764_ = type_23(_e12767, _e12764);
} else {
phi_31764_ = type_23(_e12764, _e12767);
}
let _e12781 = phi_31764_;
if _e982 {
phi_31815_ = 0u;
} else {
if (_e766 == 1u) {
phi_31814_ = 0u;
} else {
if (_e766 == 2u) {
phi_31813_ = _e12623;
} else {
phi_31813_ = select(_e12629, _e12626, (_e766 == 3u));
}
let _e12789 = phi_31813_;
phi_31814_ = _e12789;
}
let _e12791 = phi_31814_;
phi_31815_ = _e12791;
}
let _e12793 = phi_31815_;
local_100 = (((bitcast<i32>(_e12793) + _e12781.member_1) * _e12620) + _e12781.member);
let _e12798 = local_100;
let _e12800 = select(_e12646, _e12798, (_e12798 < _e12646));
let _e12805 = global_6.member[bitcast<u32>(select(0i, _e12800, (_e12800 > 0i)))];
let _e12810 = (((((select(_e12771, _e12775, _e453) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e12815 = ((1f - (((select(_e12775, _e12771, _e453) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e12822 = ((_e11788.member * _e12810) + (_e11796.member * _e12815));
let _e12823 = ((_e11788.member_1 * _e12810) + (_e11796.member_1 * _e12815));
let _e12824 = ((_e11788.member_2 * _e12810) + (_e11796.member_2 * _e12815));
let _e12828 = select((_e11811.member + _e12822), _e11811.member, _e11809);
let _e12829 = select((_e11811.member_1 + _e12823), _e11811.member_1, _e11809);
let _e12830 = select((_e11811.member_2 + _e12824), _e11811.member_2, _e11809);
let _e12841 = (((_e12828 * _e12828) + (_e12829 * _e12829)) + (_e12830 * _e12830));
let _e12845 = (1f / sqrt(select(0f, _e12841, (_e12841 > 0f))));
let _e12846 = (_e12828 * _e12845);
let _e12847 = (_e12829 * _e12845);
let _e12848 = (_e12830 * _e12845);
let _e12849 = (_e575 - select(_e11822.member, (_e11822.member + _e12822), _e11809));
let _e12850 = (_e587 - select(_e11822.member_1, (_e11822.member_1 + _e12823), _e11809));
let _e12851 = (_e600 - select(_e11822.member_2, (_e11822.member_2 + _e12824), _e11809));
let _e12856 = (((_e12849 * _e12846) + (_e12850 * _e12847)) + (_e12851 * _e12848));
let _e12861 = (((_e12849 * _e613) + (_e12850 * _e626)) + (_e12851 * _e639));
let _e12866 = (((_e12846 * _e613) + (_e12847 * _e626)) + (_e12848 * _e639));
let _e12869 = ((_e12847 * _e639) - (_e12848 * _e626));
let _e12872 = ((_e12848 * _e613) - (_e12846 * _e639));
let _e12875 = ((_e12846 * _e626) - (_e12847 * _e613));
let _e12880 = (((_e12869 * _e12869) + (_e12872 * _e12872)) + (_e12875 * _e12875));
let _e12883 = (1f / select(1e-9f, _e12880, (_e12880 > 1e-9f)));
let _e12886 = ((_e12856 - (_e12866 * _e12861)) * _e12883);
let _e12889 = (((_e12866 * _e12856) - _e12861) * _e12883);
let _e12895 = select(0f, _e12886, (((_e12889 >= 0f) && (_e12889 < _e691)) && (_e12886 > 0f)));
let _e12897 = (_e12764 << bitcast<u32>(_e7199));
let _e12909 = (_e12581 + 1i);
if _e12591 {
phi_32476_ = (_e12541.member - 1i);
} else {
phi_32476_ = _e12590;
}
let _e12913 = phi_32476_;
let _e12915 = select(_e12909, 0i, (_e12909 < 0i));
let _e12916 = (_e12915 >= _e12541.member_1);
if _e12916 {
phi_32487_ = (_e12541.member_1 - 1i);
} else {
phi_32487_ = _e12915;
}
let _e12919 = phi_32487_;
let _e12923 = (((f32(_e12913) + 0.5f) * _e12546) - 0.5f);
let _e12927 = (((f32(_e12919) + 0.5f) * _e12546) - 0.5f);
if _e453 {
phi_32515_ = type_23(_e12919, _e12913);
} else {
phi_32515_ = type_23(_e12913, _e12919);
}
let _e12933 = phi_32515_;
if _e982 {
phi_32566_ = 0u;
} else {
if (_e766 == 1u) {
phi_32565_ = 0u;
} else {
if (_e766 == 2u) {
phi_32564_ = _e12623;
} else {
phi_32564_ = select(_e12629, _e12626, (_e766 == 3u));
}
let _e12941 = phi_32564_;
phi_32565_ = _e12941;
}
let _e12943 = phi_32565_;
phi_32566_ = _e12943;
}
let _e12945 = phi_32566_;
local_98 = (((bitcast<i32>(_e12945) + _e12933.member_1) * _e12620) + _e12933.member);
let _e12950 = local_98;
let _e12952 = select(_e12646, _e12950, (_e12950 < _e12646));
let _e12957 = global_6.member[bitcast<u32>(select(0i, _e12952, (_e12952 > 0i)))];
let _e12962 = (((((select(_e12923, _e12927, _e453) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e12967 = ((1f - (((select(_e12927, _e12923, _e453) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e12974 = ((_e11788.member * _e12962) + (_e11796.member * _e12967));
let _e12975 = ((_e11788.member_1 * _e12962) + (_e11796.member_1 * _e12967));
let _e12976 = ((_e11788.member_2 * _e12962) + (_e11796.member_2 * _e12967));
let _e12980 = select((_e11811.member + _e12974), _e11811.member, _e11809);
let _e12981 = select((_e11811.member_1 + _e12975), _e11811.member_1, _e11809);
let _e12982 = select((_e11811.member_2 + _e12976), _e11811.member_2, _e11809);
let _e12993 = (((_e12980 * _e12980) + (_e12981 * _e12981)) + (_e12982 * _e12982));
let _e12997 = (1f / sqrt(select(0f, _e12993, (_e12993 > 0f))));
let _e12998 = (_e12980 * _e12997);
let _e12999 = (_e12981 * _e12997);
let _e13000 = (_e12982 * _e12997);
let _e13001 = (_e575 - select(_e11822.member, (_e11822.member + _e12974), _e11809));
let _e13002 = (_e587 - select(_e11822.member_1, (_e11822.member_1 + _e12975), _e11809));
let _e13003 = (_e600 - select(_e11822.member_2, (_e11822.member_2 + _e12976), _e11809));
let _e13008 = (((_e13001 * _e12998) + (_e13002 * _e12999)) + (_e13003 * _e13000));
let _e13013 = (((_e13001 * _e613) + (_e13002 * _e626)) + (_e13003 * _e639));
let _e13018 = (((_e12998 * _e613) + (_e12999 * _e626)) + (_e13000 * _e639));
let _e13021 = ((_e12999 * _e639) - (_e13000 * _e626));
let _e13024 = ((_e13000 * _e613) - (_e12998 * _e639));
let _e13027 = ((_e12998 * _e626) - (_e12999 * _e613));
let _e13032 = (((_e13021 * _e13021) + (_e13024 * _e13024)) + (_e13027 * _e13027));
let _e13035 = (1f / select(1e-9f, _e13032, (_e13032 > 1e-9f)));
let _e13038 = ((_e13008 - (_e13018 * _e13013)) * _e13035);
let _e13041 = (((_e13018 * _e13008) - _e13013) * _e13035);
let _e13047 = select(0f, _e13038, (((_e13041 >= 0f) && (_e13041 < _e691)) && (_e13038 > 0f)));
let _e13049 = (_e12913 << bitcast<u32>(_e7199));
if _e12761 {
phi_33227_ = (_e12541.member - 1i);
} else {
phi_33227_ = _e12760;
}
let _e13064 = phi_33227_;
if _e12916 {
phi_33238_ = (_e12541.member_1 - 1i);
} else {
phi_33238_ = _e12915;
}
let _e13067 = phi_33238_;
let _e13071 = (((f32(_e13064) + 0.5f) * _e12546) - 0.5f);
let _e13075 = (((f32(_e13067) + 0.5f) * _e12546) - 0.5f);
if _e453 {
phi_33266_ = type_23(_e13067, _e13064);
} else {
phi_33266_ = type_23(_e13064, _e13067);
}
let _e13081 = phi_33266_;
if _e982 {
phi_33317_ = 0u;
} else {
if (_e766 == 1u) {
phi_33316_ = 0u;
} else {
if (_e766 == 2u) {
phi_33315_ = _e12623;
} else {
phi_33315_ = select(_e12629, _e12626, (_e766 == 3u));
}
let _e13089 = phi_33315_;
phi_33316_ = _e13089;
}
let _e13091 = phi_33316_;
phi_33317_ = _e13091;
}
let _e13093 = phi_33317_;
local_96 = (((bitcast<i32>(_e13093) + _e13081.member_1) * _e12620) + _e13081.member);
let _e13098 = local_96;
let _e13100 = select(_e12646, _e13098, (_e13098 < _e12646));
let _e13105 = global_6.member[bitcast<u32>(select(0i, _e13100, (_e13100 > 0i)))];
let _e13110 = (((((select(_e13071, _e13075, _e453) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e13115 = ((1f - (((select(_e13075, _e13071, _e453) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e13122 = ((_e11788.member * _e13110) + (_e11796.member * _e13115));
let _e13123 = ((_e11788.member_1 * _e13110) + (_e11796.member_1 * _e13115));
let _e13124 = ((_e11788.member_2 * _e13110) + (_e11796.member_2 * _e13115));
let _e13128 = select((_e11811.member + _e13122), _e11811.member, _e11809);
let _e13129 = select((_e11811.member_1 + _e13123), _e11811.member_1, _e11809);
let _e13130 = select((_e11811.member_2 + _e13124), _e11811.member_2, _e11809);
let _e13141 = (((_e13128 * _e13128) + (_e13129 * _e13129)) + (_e13130 * _e13130));
let _e13145 = (1f / sqrt(select(0f, _e13141, (_e13141 > 0f))));
let _e13146 = (_e13128 * _e13145);
let _e13147 = (_e13129 * _e13145);
let _e13148 = (_e13130 * _e13145);
let _e13149 = (_e575 - select(_e11822.member, (_e11822.member + _e13122), _e11809));
let _e13150 = (_e587 - select(_e11822.member_1, (_e11822.member_1 + _e13123), _e11809));
let _e13151 = (_e600 - select(_e11822.member_2, (_e11822.member_2 + _e13124), _e11809));
let _e13156 = (((_e13149 * _e13146) + (_e13150 * _e13147)) + (_e13151 * _e13148));
let _e13161 = (((_e13149 * _e613) + (_e13150 * _e626)) + (_e13151 * _e639));
let _e13166 = (((_e13146 * _e613) + (_e13147 * _e626)) + (_e13148 * _e639));
let _e13169 = ((_e13147 * _e639) - (_e13148 * _e626));
let _e13172 = ((_e13148 * _e613) - (_e13146 * _e639));
let _e13175 = ((_e13146 * _e626) - (_e13147 * _e613));
let _e13180 = (((_e13169 * _e13169) + (_e13172 * _e13172)) + (_e13175 * _e13175));
let _e13183 = (1f / select(1e-9f, _e13180, (_e13180 > 1e-9f)));
let _e13186 = ((_e13156 - (_e13166 * _e13161)) * _e13183);
let _e13189 = (((_e13166 * _e13156) - _e13161) * _e13183);
let _e13195 = select(0f, _e13186, (((_e13189 >= 0f) && (_e13189 < _e691)) && (_e13186 > 0f)));
let _e13197 = (_e13064 << bitcast<u32>(_e7199));
let _e13209 = select(((((1f - select(0f, (_e12586 * _e12587), (((select(select(_e766, _e923, (_e12745 >= _e692)), _e845, (_e12745 < _e298)) == _e766) && (_e12743 > 0f)) && (_e12743 < _e12653)))) - select(0f, (_e12583 * _e12587), (((select(select(_e766, _e923, (_e12897 >= _e692)), _e845, (_e12897 < _e298)) == _e766) && (_e12895 > 0f)) && (_e12895 < _e12805)))) - select(0f, (_e12586 * _e12585), (((select(select(_e766, _e923, (_e13049 >= _e692)), _e845, (_e13049 < _e298)) == _e766) && (_e13047 > 0f)) && (_e13047 < _e12957)))) - select(0f, (_e12583 * _e12585), (((select(select(_e766, _e923, (_e13197 >= _e692)), _e845, (_e13197 < _e298)) == _e766) && (_e13195 > 0f)) && (_e13195 < _e13105)))), 1f, _e982);
let _e13210 = (_e8550 & 31u);
let _e13212 = (1u << bitcast<u32>(_e13210));
let _e13221 = bitcast<i32>((((_e927 + _e13212) - 1u) >> bitcast<u32>(_e13210)));
let _e13222 = bitcast<i32>((((_e930 + _e13212) - 1u) >> bitcast<u32>(_e13210)));
if _e453 {
phi_33996_ = type_23(_e13222, _e13221);
} else {
phi_33996_ = type_23(_e13221, _e13222);
}
let _e13226 = phi_33996_;
let _e13231 = f32((1i << bitcast<u32>(_e13210)));
let _e13232 = (1f / _e13231);
let _e13234 = ((_e11583 * _e13232) - 0.5f);
let _e13236 = ((_e11677 * _e13232) - 0.5f);
let _e13238 = select(-1f, _e13234, (_e13234 > -1f));
let _e13240 = select(1e6f, _e13238, (_e13238 < 1e6f));
let _e13247 = select(0i, select(select(i32(_e13240), i32(-2147483648), (_e13240 < -2147483600f)), 2147483647i, (_e13240 > 2147483500f)), (_e13240 == _e13240));
let _e13251 = (_e13247 - select(0i, 1i, (_e13240 < f32(_e13247))));
let _e13253 = select(-1f, _e13236, (_e13236 > -1f));
let _e13255 = select(1e6f, _e13253, (_e13253 < 1e6f));
let _e13262 = select(0i, select(select(i32(_e13255), i32(-2147483648), (_e13255 < -2147483600f)), 2147483647i, (_e13255 > 2147483500f)), (_e13255 == _e13255));
let _e13266 = (_e13262 - select(0i, 1i, (_e13255 < f32(_e13262))));
let _e13268 = (_e13234 - f32(_e13251));
let _e13270 = (_e13236 - f32(_e13266));
let _e13271 = (1f - _e13268);
let _e13272 = (1f - _e13270);
let _e13275 = select(_e13251, 0i, (_e13251 < 0i));
let _e13276 = (_e13275 >= _e13226.member);
if _e13276 {
phi_34074_ = (_e13226.member - 1i);
} else {
phi_34074_ = _e13275;
}
let _e13279 = phi_34074_;
let _e13281 = select(_e13266, 0i, (_e13266 < 0i));
let _e13282 = (_e13281 >= _e13226.member_1);
if _e13282 {
phi_34085_ = (_e13226.member_1 - 1i);
} else {
phi_34085_ = _e13281;
}
let _e13285 = phi_34085_;
let _e13289 = (((f32(_e13279) + 0.5f) * _e13231) - 0.5f);
let _e13293 = (((f32(_e13285) + 0.5f) * _e13231) - 0.5f);
if _e453 {
phi_34113_ = type_23(_e13285, _e13279);
} else {
phi_34113_ = type_23(_e13279, _e13285);
}
let _e13299 = phi_34113_;
let _e13302 = (_e8550 == 0u);
if _e13302 {
phi_34164_ = 0u;
} else {
if (_e8550 == 1u) {
phi_34163_ = 0u;
} else {
if (_e8550 == 2u) {
phi_34162_ = _e12623;
} else {
phi_34162_ = select(_e12629, _e12626, (_e8550 == 3u));
}
let _e13308 = phi_34162_;
phi_34163_ = _e13308;
}
let _e13310 = phi_34163_;
phi_34164_ = _e13310;
}
let _e13312 = phi_34164_;
local_94 = (((bitcast<i32>(_e13312) + _e13299.member_1) * _e12620) + _e13299.member);
let _e13317 = local_94;
let _e13319 = select(_e12646, _e13317, (_e13317 < _e12646));
let _e13324 = global_6.member[bitcast<u32>(select(0i, _e13319, (_e13319 > 0i)))];
let _e13329 = (((((select(_e13289, _e13293, _e453) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e13334 = ((1f - (((select(_e13293, _e13289, _e453) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e13341 = ((_e11788.member * _e13329) + (_e11796.member * _e13334));
let _e13342 = ((_e11788.member_1 * _e13329) + (_e11796.member_1 * _e13334));
let _e13343 = ((_e11788.member_2 * _e13329) + (_e11796.member_2 * _e13334));
let _e13347 = select((_e11811.member + _e13341), _e11811.member, _e11809);
let _e13348 = select((_e11811.member_1 + _e13342), _e11811.member_1, _e11809);
let _e13349 = select((_e11811.member_2 + _e13343), _e11811.member_2, _e11809);
let _e13360 = (((_e13347 * _e13347) + (_e13348 * _e13348)) + (_e13349 * _e13349));
let _e13364 = (1f / sqrt(select(0f, _e13360, (_e13360 > 0f))));
let _e13365 = (_e13347 * _e13364);
let _e13366 = (_e13348 * _e13364);
let _e13367 = (_e13349 * _e13364);
let _e13368 = (_e575 - select(_e11822.member, (_e11822.member + _e13341), _e11809));
let _e13369 = (_e587 - select(_e11822.member_1, (_e11822.member_1 + _e13342), _e11809));
let _e13370 = (_e600 - select(_e11822.member_2, (_e11822.member_2 + _e13343), _e11809));
let _e13375 = (((_e13368 * _e13365) + (_e13369 * _e13366)) + (_e13370 * _e13367));
let _e13380 = (((_e13368 * _e613) + (_e13369 * _e626)) + (_e13370 * _e639));
let _e13385 = (((_e13365 * _e613) + (_e13366 * _e626)) + (_e13367 * _e639));
let _e13388 = ((_e13366 * _e639) - (_e13367 * _e626));
let _e13391 = ((_e13367 * _e613) - (_e13365 * _e639));
let _e13394 = ((_e13365 * _e626) - (_e13366 * _e613));
let _e13399 = (((_e13388 * _e13388) + (_e13391 * _e13391)) + (_e13394 * _e13394));
let _e13402 = (1f / select(1e-9f, _e13399, (_e13399 > 1e-9f)));
let _e13405 = ((_e13375 - (_e13385 * _e13380)) * _e13402);
let _e13408 = (((_e13385 * _e13375) - _e13380) * _e13402);
let _e13414 = select(0f, _e13405, (((_e13408 >= 0f) && (_e13408 < _e691)) && (_e13405 > 0f)));
let _e13416 = (_e13279 << bitcast<u32>(_e13210));
let _e13428 = (_e13251 + 1i);
let _e13431 = select(_e13428, 0i, (_e13428 < 0i));
let _e13432 = (_e13431 >= _e13226.member);
if _e13432 {
phi_34825_ = (_e13226.member - 1i);
} else {
phi_34825_ = _e13431;
}
let _e13435 = phi_34825_;
if _e13282 {
phi_34836_ = (_e13226.member_1 - 1i);
} else {
phi_34836_ = _e13281;
}
let _e13438 = phi_34836_;
let _e13442 = (((f32(_e13435) + 0.5f) * _e13231) - 0.5f);
let _e13446 = (((f32(_e13438) + 0.5f) * _e13231) - 0.5f);
if _e453 {
phi_34864_ = type_23(_e13438, _e13435);
} else {
phi_34864_ = type_23(_e13435, _e13438);
}
let _e13452 = phi_34864_;
if _e13302 {
phi_34915_ = 0u;
} else {
if (_e8550 == 1u) {
phi_34914_ = 0u;
} else {
if (_e8550 == 2u) {
phi_34913_ = _e12623;
} else {
phi_34913_ = select(_e12629, _e12626, (_e8550 == 3u));
}
let _e13460 = phi_34913_;
phi_34914_ = _e13460;
}
let _e13462 = phi_34914_;
phi_34915_ = _e13462;
}
let _e13464 = phi_34915_;
local_92 = (((bitcast<i32>(_e13464) + _e13452.member_1) * _e12620) + _e13452.member);
let _e13469 = local_92;
let _e13471 = select(_e12646, _e13469, (_e13469 < _e12646));
let _e13476 = global_6.member[bitcast<u32>(select(0i, _e13471, (_e13471 > 0i)))];
let _e13481 = (((((select(_e13442, _e13446, _e453) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e13486 = ((1f - (((select(_e13446, _e13442, _e453) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e13493 = ((_e11788.member * _e13481) + (_e11796.member * _e13486));
let _e13494 = ((_e11788.member_1 * _e13481) + (_e11796.member_1 * _e13486));
let _e13495 = ((_e11788.member_2 * _e13481) + (_e11796.member_2 * _e13486));
let _e13499 = select((_e11811.member + _e13493), _e11811.member, _e11809);
let _e13500 = select((_e11811.member_1 + _e13494), _e11811.member_1, _e11809);
let _e13501 = select((_e11811.member_2 + _e13495), _e11811.member_2, _e11809);
let _e13512 = (((_e13499 * _e13499) + (_e13500 * _e13500)) + (_e13501 * _e13501));
let _e13516 = (1f / sqrt(select(0f, _e13512, (_e13512 > 0f))));
let _e13517 = (_e13499 * _e13516);
let _e13518 = (_e13500 * _e13516);
let _e13519 = (_e13501 * _e13516);
let _e13520 = (_e575 - select(_e11822.member, (_e11822.member + _e13493), _e11809));
let _e13521 = (_e587 - select(_e11822.member_1, (_e11822.member_1 + _e13494), _e11809));
let _e13522 = (_e600 - select(_e11822.member_2, (_e11822.member_2 + _e13495), _e11809));
let _e13527 = (((_e13520 * _e13517) + (_e13521 * _e13518)) + (_e13522 * _e13519));
let _e13532 = (((_e13520 * _e613) + (_e13521 * _e626)) + (_e13522 * _e639));
let _e13537 = (((_e13517 * _e613) + (_e13518 * _e626)) + (_e13519 * _e639));
let _e13540 = ((_e13518 * _e639) - (_e13519 * _e626));
let _e13543 = ((_e13519 * _e613) - (_e13517 * _e639));
let _e13546 = ((_e13517 * _e626) - (_e13518 * _e613));
let _e13551 = (((_e13540 * _e13540) + (_e13543 * _e13543)) + (_e13546 * _e13546));
let _e13554 = (1f / select(1e-9f, _e13551, (_e13551 > 1e-9f)));
let _e13557 = ((_e13527 - (_e13537 * _e13532)) * _e13554);
let _e13560 = (((_e13537 * _e13527) - _e13532) * _e13554);
let _e13566 = select(0f, _e13557, (((_e13560 >= 0f) && (_e13560 < _e691)) && (_e13557 > 0f)));
let _e13568 = (_e13435 << bitcast<u32>(_e13210));
let _e13580 = (_e13266 + 1i);
if _e13276 {
phi_35576_ = (_e13226.member - 1i);
} else {
phi_35576_ = _e13275;
}
let _e13584 = phi_35576_;
let _e13586 = select(_e13580, 0i, (_e13580 < 0i));
let _e13587 = (_e13586 >= _e13226.member_1);
if _e13587 {
phi_35587_ = (_e13226.member_1 - 1i);
} else {
phi_35587_ = _e13586;
}
let _e13590 = phi_35587_;
let _e13594 = (((f32(_e13584) + 0.5f) * _e13231) - 0.5f);
let _e13598 = (((f32(_e13590) + 0.5f) * _e13231) - 0.5f);
if _e453 {
phi_35615_ = type_23(_e13590, _e13584);
} else {
phi_35615_ = type_23(_e13584, _e13590);
}
let _e13604 = phi_35615_;
if _e13302 {
phi_35666_ = 0u;
} else {
if (_e8550 == 1u) {
phi_35665_ = 0u;
} else {
if (_e8550 == 2u) {
phi_35664_ = _e12623;
} else {
phi_35664_ = select(_e12629, _e12626, (_e8550 == 3u));
}
let _e13612 = phi_35664_;
phi_35665_ = _e13612;
}
let _e13614 = phi_35665_;
phi_35666_ = _e13614;
}
let _e13616 = phi_35666_;
local_90 = (((bitcast<i32>(_e13616) + _e13604.member_1) * _e12620) + _e13604.member);
let _e13621 = local_90;
let _e13623 = select(_e12646, _e13621, (_e13621 < _e12646));
let _e13628 = global_6.member[bitcast<u32>(select(0i, _e13623, (_e13623 > 0i)))];
let _e13633 = (((((select(_e13594, _e13598, _e453) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e13638 = ((1f - (((select(_e13598, _e13594, _e453) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e13645 = ((_e11788.member * _e13633) + (_e11796.member * _e13638));
let _e13646 = ((_e11788.member_1 * _e13633) + (_e11796.member_1 * _e13638));
let _e13647 = ((_e11788.member_2 * _e13633) + (_e11796.member_2 * _e13638));
let _e13651 = select((_e11811.member + _e13645), _e11811.member, _e11809);
let _e13652 = select((_e11811.member_1 + _e13646), _e11811.member_1, _e11809);
let _e13653 = select((_e11811.member_2 + _e13647), _e11811.member_2, _e11809);
let _e13664 = (((_e13651 * _e13651) + (_e13652 * _e13652)) + (_e13653 * _e13653));
let _e13668 = (1f / sqrt(select(0f, _e13664, (_e13664 > 0f))));
let _e13669 = (_e13651 * _e13668);
let _e13670 = (_e13652 * _e13668);
let _e13671 = (_e13653 * _e13668);
let _e13672 = (_e575 - select(_e11822.member, (_e11822.member + _e13645), _e11809));
let _e13673 = (_e587 - select(_e11822.member_1, (_e11822.member_1 + _e13646), _e11809));
let _e13674 = (_e600 - select(_e11822.member_2, (_e11822.member_2 + _e13647), _e11809));
let _e13679 = (((_e13672 * _e13669) + (_e13673 * _e13670)) + (_e13674 * _e13671));
let _e13684 = (((_e13672 * _e613) + (_e13673 * _e626)) + (_e13674 * _e639));
let _e13689 = (((_e13669 * _e613) + (_e13670 * _e626)) + (_e13671 * _e639));
let _e13692 = ((_e13670 * _e639) - (_e13671 * _e626));
let _e13695 = ((_e13671 * _e613) - (_e13669 * _e639));
let _e13698 = ((_e13669 * _e626) - (_e13670 * _e613));
let _e13703 = (((_e13692 * _e13692) + (_e13695 * _e13695)) + (_e13698 * _e13698));
let _e13706 = (1f / select(1e-9f, _e13703, (_e13703 > 1e-9f)));
let _e13709 = ((_e13679 - (_e13689 * _e13684)) * _e13706);
let _e13712 = (((_e13689 * _e13679) - _e13684) * _e13706);
let _e13718 = select(0f, _e13709, (((_e13712 >= 0f) && (_e13712 < _e691)) && (_e13709 > 0f)));
let _e13720 = (_e13584 << bitcast<u32>(_e13210));
if _e13432 {
phi_36327_ = (_e13226.member - 1i);
} else {
phi_36327_ = _e13431;
}
let _e13735 = phi_36327_;
if _e13587 {
phi_36338_ = (_e13226.member_1 - 1i);
} else {
phi_36338_ = _e13586;
}
let _e13738 = phi_36338_;
let _e13742 = (((f32(_e13735) + 0.5f) * _e13231) - 0.5f);
let _e13746 = (((f32(_e13738) + 0.5f) * _e13231) - 0.5f);
if _e453 {
phi_36366_ = type_23(_e13738, _e13735);
} else {
phi_36366_ = type_23(_e13735, _e13738);
}
let _e13752 = phi_36366_;
if _e13302 {
phi_36417_ = 0u;
} else {
if (_e8550 == 1u) {
phi_36416_ = 0u;
} else {
if (_e8550 == 2u) {
phi_36415_ = _e12623;
} else {
phi_36415_ = select(_e12629, _e12626, (_e8550 == 3u));
}
let _e13760 = phi_36415_;
phi_36416_ = _e13760;
}
let _e13762 = phi_36416_;
phi_36417_ = _e13762;
}
let _e13764 = phi_36417_;
local_88 = (((bitcast<i32>(_e13764) + _e13752.member_1) * _e12620) + _e13752.member);
let _e13769 = local_88;
let _e13771 = select(_e12646, _e13769, (_e13769 < _e12646));
let _e13776 = global_6.member[bitcast<u32>(select(0i, _e13771, (_e13771 > 0i)))];
let _e13781 = (((((select(_e13742, _e13746, _e453) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e13786 = ((1f - (((select(_e13746, _e13742, _e453) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e13793 = ((_e11788.member * _e13781) + (_e11796.member * _e13786));
let _e13794 = ((_e11788.member_1 * _e13781) + (_e11796.member_1 * _e13786));
let _e13795 = ((_e11788.member_2 * _e13781) + (_e11796.member_2 * _e13786));
let _e13799 = select((_e11811.member + _e13793), _e11811.member, _e11809);
let _e13800 = select((_e11811.member_1 + _e13794), _e11811.member_1, _e11809);
let _e13801 = select((_e11811.member_2 + _e13795), _e11811.member_2, _e11809);
let _e13812 = (((_e13799 * _e13799) + (_e13800 * _e13800)) + (_e13801 * _e13801));
let _e13816 = (1f / sqrt(select(0f, _e13812, (_e13812 > 0f))));
let _e13817 = (_e13799 * _e13816);
let _e13818 = (_e13800 * _e13816);
let _e13819 = (_e13801 * _e13816);
let _e13820 = (_e575 - select(_e11822.member, (_e11822.member + _e13793), _e11809));
let _e13821 = (_e587 - select(_e11822.member_1, (_e11822.member_1 + _e13794), _e11809));
let _e13822 = (_e600 - select(_e11822.member_2, (_e11822.member_2 + _e13795), _e11809));
let _e13827 = (((_e13820 * _e13817) + (_e13821 * _e13818)) + (_e13822 * _e13819));
let _e13832 = (((_e13820 * _e613) + (_e13821 * _e626)) + (_e13822 * _e639));
let _e13837 = (((_e13817 * _e613) + (_e13818 * _e626)) + (_e13819 * _e639));
let _e13840 = ((_e13818 * _e639) - (_e13819 * _e626));
let _e13843 = ((_e13819 * _e613) - (_e13817 * _e639));
let _e13846 = ((_e13817 * _e626) - (_e13818 * _e613));
let _e13851 = (((_e13840 * _e13840) + (_e13843 * _e13843)) + (_e13846 * _e13846));
let _e13854 = (1f / select(1e-9f, _e13851, (_e13851 > 1e-9f)));
let _e13857 = ((_e13827 - (_e13837 * _e13832)) * _e13854);
let _e13860 = (((_e13837 * _e13827) - _e13832) * _e13854);
let _e13866 = select(0f, _e13857, (((_e13860 >= 0f) && (_e13860 < _e691)) && (_e13857 > 0f)));
let _e13868 = (_e13735 << bitcast<u32>(_e13210));
let _e13880 = select(((((_e13209 - select(0f, (_e13271 * _e13272), (((select(select(_e766, _e923, (_e13416 >= _e692)), _e845, (_e13416 < _e298)) == _e8550) && (_e13414 > 0f)) && (_e13414 < _e13324)))) - select(0f, (_e13268 * _e13272), (((select(select(_e766, _e923, (_e13568 >= _e692)), _e845, (_e13568 < _e298)) == _e8550) && (_e13566 > 0f)) && (_e13566 < _e13476)))) - select(0f, (_e13271 * _e13270), (((select(select(_e766, _e923, (_e13720 >= _e692)), _e845, (_e13720 < _e298)) == _e8550) && (_e13718 > 0f)) && (_e13718 < _e13628)))) - select(0f, (_e13268 * _e13270), (((select(select(_e766, _e923, (_e13868 >= _e692)), _e845, (_e13868 < _e298)) == _e8550) && (_e13866 > 0f)) && (_e13866 < _e13776)))), _e13209, _e13302);
let _e13881 = (_e8554 & 31u);
let _e13883 = (1u << bitcast<u32>(_e13881));
let _e13892 = bitcast<i32>((((_e927 + _e13883) - 1u) >> bitcast<u32>(_e13881)));
let _e13893 = bitcast<i32>((((_e930 + _e13883) - 1u) >> bitcast<u32>(_e13881)));
if _e453 {
phi_37096_ = type_23(_e13893, _e13892);
} else {
phi_37096_ = type_23(_e13892, _e13893);
}
let _e13897 = phi_37096_;
let _e13902 = f32((1i << bitcast<u32>(_e13881)));
let _e13903 = (1f / _e13902);
let _e13905 = ((_e11583 * _e13903) - 0.5f);
let _e13907 = ((_e11677 * _e13903) - 0.5f);
let _e13909 = select(-1f, _e13905, (_e13905 > -1f));
let _e13911 = select(1e6f, _e13909, (_e13909 < 1e6f));
let _e13918 = select(0i, select(select(i32(_e13911), i32(-2147483648), (_e13911 < -2147483600f)), 2147483647i, (_e13911 > 2147483500f)), (_e13911 == _e13911));
let _e13922 = (_e13918 - select(0i, 1i, (_e13911 < f32(_e13918))));
let _e13924 = select(-1f, _e13907, (_e13907 > -1f));
let _e13926 = select(1e6f, _e13924, (_e13924 < 1e6f));
let _e13933 = select(0i, select(select(i32(_e13926), i32(-2147483648), (_e13926 < -2147483600f)), 2147483647i, (_e13926 > 2147483500f)), (_e13926 == _e13926));
let _e13937 = (_e13933 - select(0i, 1i, (_e13926 < f32(_e13933))));
let _e13939 = (_e13905 - f32(_e13922));
let _e13941 = (_e13907 - f32(_e13937));
let _e13942 = (1f - _e13939);
let _e13943 = (1f - _e13941);
let _e13946 = select(_e13922, 0i, (_e13922 < 0i));
let _e13947 = (_e13946 >= _e13897.member);
if _e13947 {
phi_37174_ = (_e13897.member - 1i);
} else {
phi_37174_ = _e13946;
}
let _e13950 = phi_37174_;
let _e13952 = select(_e13937, 0i, (_e13937 < 0i));
let _e13953 = (_e13952 >= _e13897.member_1);
if _e13953 {
phi_37185_ = (_e13897.member_1 - 1i);
} else {
phi_37185_ = _e13952;
}
let _e13956 = phi_37185_;
let _e13960 = (((f32(_e13950) + 0.5f) * _e13902) - 0.5f);
let _e13964 = (((f32(_e13956) + 0.5f) * _e13902) - 0.5f);
if _e453 {
phi_37213_ = type_23(_e13956, _e13950);
} else {
phi_37213_ = type_23(_e13950, _e13956);
}
let _e13970 = phi_37213_;
let _e13973 = (_e8554 == 0u);
if _e13973 {
phi_37264_ = 0u;
} else {
if (_e8554 == 1u) {
phi_37263_ = 0u;
} else {
if (_e8554 == 2u) {
phi_37262_ = _e12623;
} else {
phi_37262_ = select(_e12629, _e12626, (_e8554 == 3u));
}
let _e13979 = phi_37262_;
phi_37263_ = _e13979;
}
let _e13981 = phi_37263_;
phi_37264_ = _e13981;
}
let _e13983 = phi_37264_;
local_86 = (((bitcast<i32>(_e13983) + _e13970.member_1) * _e12620) + _e13970.member);
let _e13988 = local_86;
let _e13990 = select(_e12646, _e13988, (_e13988 < _e12646));
let _e13995 = global_6.member[bitcast<u32>(select(0i, _e13990, (_e13990 > 0i)))];
let _e14000 = (((((select(_e13960, _e13964, _e453) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e14005 = ((1f - (((select(_e13964, _e13960, _e453) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e14012 = ((_e11788.member * _e14000) + (_e11796.member * _e14005));
let _e14013 = ((_e11788.member_1 * _e14000) + (_e11796.member_1 * _e14005));
let _e14014 = ((_e11788.member_2 * _e14000) + (_e11796.member_2 * _e14005));
let _e14018 = select((_e11811.member + _e14012), _e11811.member, _e11809);
let _e14019 = select((_e11811.member_1 + _e14013), _e11811.member_1, _e11809);
let _e14020 = select((_e11811.member_2 + _e14014), _e11811.member_2, _e11809);
let _e14031 = (((_e14018 * _e14018) + (_e14019 * _e14019)) + (_e14020 * _e14020));
let _e14035 = (1f / sqrt(select(0f, _e14031, (_e14031 > 0f))));
let _e14036 = (_e14018 * _e14035);
let _e14037 = (_e14019 * _e14035);
let _e14038 = (_e14020 * _e14035);
let _e14039 = (_e575 - select(_e11822.member, (_e11822.member + _e14012), _e11809));
let _e14040 = (_e587 - select(_e11822.member_1, (_e11822.member_1 + _e14013), _e11809));
let _e14041 = (_e600 - select(_e11822.member_2, (_e11822.member_2 + _e14014), _e11809));
let _e14046 = (((_e14039 * _e14036) + (_e14040 * _e14037)) + (_e14041 * _e14038));
let _e14051 = (((_e14039 * _e613) + (_e14040 * _e626)) + (_e14041 * _e639));
let _e14056 = (((_e14036 * _e613) + (_e14037 * _e626)) + (_e14038 * _e639));
let _e14059 = ((_e14037 * _e639) - (_e14038 * _e626));
let _e14062 = ((_e14038 * _e613) - (_e14036 * _e639));
let _e14065 = ((_e14036 * _e626) - (_e14037 * _e613));
let _e14070 = (((_e14059 * _e14059) + (_e14062 * _e14062)) + (_e14065 * _e14065));
let _e14073 = (1f / select(1e-9f, _e14070, (_e14070 > 1e-9f)));
let _e14076 = ((_e14046 - (_e14056 * _e14051)) * _e14073);
let _e14079 = (((_e14056 * _e14046) - _e14051) * _e14073);
let _e14085 = select(0f, _e14076, (((_e14079 >= 0f) && (_e14079 < _e691)) && (_e14076 > 0f)));
let _e14087 = (_e13950 << bitcast<u32>(_e13881));
let _e14099 = (_e13922 + 1i);
let _e14102 = select(_e14099, 0i, (_e14099 < 0i));
let _e14103 = (_e14102 >= _e13897.member);
if _e14103 {
phi_37925_ = (_e13897.member - 1i);
} else {
phi_37925_ = _e14102;
}
let _e14106 = phi_37925_;
if _e13953 {
phi_37936_ = (_e13897.member_1 - 1i);
} else {
phi_37936_ = _e13952;
}
let _e14109 = phi_37936_;
let _e14113 = (((f32(_e14106) + 0.5f) * _e13902) - 0.5f);
let _e14117 = (((f32(_e14109) + 0.5f) * _e13902) - 0.5f);
if _e453 {
phi_37964_ = type_23(_e14109, _e14106);
} else {
phi_37964_ = type_23(_e14106, _e14109);
}
let _e14123 = phi_37964_;
if _e13973 {
phi_38015_ = 0u;
} else {
if (_e8554 == 1u) {
phi_38014_ = 0u;
} else {
if (_e8554 == 2u) {
phi_38013_ = _e12623;
} else {
phi_38013_ = select(_e12629, _e12626, (_e8554 == 3u));
}
let _e14131 = phi_38013_;
phi_38014_ = _e14131;
}
let _e14133 = phi_38014_;
phi_38015_ = _e14133;
}
let _e14135 = phi_38015_;
local_84 = (((bitcast<i32>(_e14135) + _e14123.member_1) * _e12620) + _e14123.member);
let _e14140 = local_84;
let _e14142 = select(_e12646, _e14140, (_e14140 < _e12646));
let _e14147 = global_6.member[bitcast<u32>(select(0i, _e14142, (_e14142 > 0i)))];
let _e14152 = (((((select(_e14113, _e14117, _e453) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e14157 = ((1f - (((select(_e14117, _e14113, _e453) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e14164 = ((_e11788.member * _e14152) + (_e11796.member * _e14157));
let _e14165 = ((_e11788.member_1 * _e14152) + (_e11796.member_1 * _e14157));
let _e14166 = ((_e11788.member_2 * _e14152) + (_e11796.member_2 * _e14157));
let _e14170 = select((_e11811.member + _e14164), _e11811.member, _e11809);
let _e14171 = select((_e11811.member_1 + _e14165), _e11811.member_1, _e11809);
let _e14172 = select((_e11811.member_2 + _e14166), _e11811.member_2, _e11809);
let _e14183 = (((_e14170 * _e14170) + (_e14171 * _e14171)) + (_e14172 * _e14172));
let _e14187 = (1f / sqrt(select(0f, _e14183, (_e14183 > 0f))));
let _e14188 = (_e14170 * _e14187);
let _e14189 = (_e14171 * _e14187);
let _e14190 = (_e14172 * _e14187);
let _e14191 = (_e575 - select(_e11822.member, (_e11822.member + _e14164), _e11809));
let _e14192 = (_e587 - select(_e11822.member_1, (_e11822.member_1 + _e14165), _e11809));
let _e14193 = (_e600 - select(_e11822.member_2, (_e11822.member_2 + _e14166), _e11809));
let _e14198 = (((_e14191 * _e14188) + (_e14192 * _e14189)) + (_e14193 * _e14190));
let _e14203 = (((_e14191 * _e613) + (_e14192 * _e626)) + (_e14193 * _e639));
let _e14208 = (((_e14188 * _e613) + (_e14189 * _e626)) + (_e14190 * _e639));
let _e14211 = ((_e14189 * _e639) - (_e14190 * _e626));
let _e14214 = ((_e14190 * _e613) - (_e14188 * _e639));
let _e14217 = ((_e14188 * _e626) - (_e14189 * _e613));
let _e14222 = (((_e14211 * _e14211) + (_e14214 * _e14214)) + (_e14217 * _e14217));
let _e14225 = (1f / select(1e-9f, _e14222, (_e14222 > 1e-9f)));
let _e14228 = ((_e14198 - (_e14208 * _e14203)) * _e14225);
let _e14231 = (((_e14208 * _e14198) - _e14203) * _e14225);
let _e14237 = select(0f, _e14228, (((_e14231 >= 0f) && (_e14231 < _e691)) && (_e14228 > 0f)));
let _e14239 = (_e14106 << bitcast<u32>(_e13881));
let _e14251 = (_e13937 + 1i);
if _e13947 {
phi_38676_ = (_e13897.member - 1i);
} else {
phi_38676_ = _e13946;
}
let _e14255 = phi_38676_;
let _e14257 = select(_e14251, 0i, (_e14251 < 0i));
let _e14258 = (_e14257 >= _e13897.member_1);
if _e14258 {
phi_38687_ = (_e13897.member_1 - 1i);
} else {
phi_38687_ = _e14257;
}
let _e14261 = phi_38687_;
let _e14265 = (((f32(_e14255) + 0.5f) * _e13902) - 0.5f);
let _e14269 = (((f32(_e14261) + 0.5f) * _e13902) - 0.5f);
if _e453 {
phi_38715_ = type_23(_e14261, _e14255);
} else {
phi_38715_ = type_23(_e14255, _e14261);
}
let _e14275 = phi_38715_;
if _e13973 {
phi_38766_ = 0u;
} else {
if (_e8554 == 1u) {
phi_38765_ = 0u;
} else {
if (_e8554 == 2u) {
phi_38764_ = _e12623;
} else {
phi_38764_ = select(_e12629, _e12626, (_e8554 == 3u));
}
let _e14283 = phi_38764_;
phi_38765_ = _e14283;
}
let _e14285 = phi_38765_;
phi_38766_ = _e14285;
}
let _e14287 = phi_38766_;
local_82 = (((bitcast<i32>(_e14287) + _e14275.member_1) * _e12620) + _e14275.member);
let _e14292 = local_82;
let _e14294 = select(_e12646, _e14292, (_e14292 < _e12646));
let _e14299 = global_6.member[bitcast<u32>(select(0i, _e14294, (_e14294 > 0i)))];
let _e14304 = (((((select(_e14265, _e14269, _e453) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e14309 = ((1f - (((select(_e14269, _e14265, _e453) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e14316 = ((_e11788.member * _e14304) + (_e11796.member * _e14309));
let _e14317 = ((_e11788.member_1 * _e14304) + (_e11796.member_1 * _e14309));
let _e14318 = ((_e11788.member_2 * _e14304) + (_e11796.member_2 * _e14309));
let _e14322 = select((_e11811.member + _e14316), _e11811.member, _e11809);
let _e14323 = select((_e11811.member_1 + _e14317), _e11811.member_1, _e11809);
let _e14324 = select((_e11811.member_2 + _e14318), _e11811.member_2, _e11809);
let _e14335 = (((_e14322 * _e14322) + (_e14323 * _e14323)) + (_e14324 * _e14324));
let _e14339 = (1f / sqrt(select(0f, _e14335, (_e14335 > 0f))));
let _e14340 = (_e14322 * _e14339);
let _e14341 = (_e14323 * _e14339);
let _e14342 = (_e14324 * _e14339);
let _e14343 = (_e575 - select(_e11822.member, (_e11822.member + _e14316), _e11809));
let _e14344 = (_e587 - select(_e11822.member_1, (_e11822.member_1 + _e14317), _e11809));
let _e14345 = (_e600 - select(_e11822.member_2, (_e11822.member_2 + _e14318), _e11809));
let _e14350 = (((_e14343 * _e14340) + (_e14344 * _e14341)) + (_e14345 * _e14342));
let _e14355 = (((_e14343 * _e613) + (_e14344 * _e626)) + (_e14345 * _e639));
let _e14360 = (((_e14340 * _e613) + (_e14341 * _e626)) + (_e14342 * _e639));
let _e14363 = ((_e14341 * _e639) - (_e14342 * _e626));
let _e14366 = ((_e14342 * _e613) - (_e14340 * _e639));
let _e14369 = ((_e14340 * _e626) - (_e14341 * _e613));
let _e14374 = (((_e14363 * _e14363) + (_e14366 * _e14366)) + (_e14369 * _e14369));
let _e14377 = (1f / select(1e-9f, _e14374, (_e14374 > 1e-9f)));
let _e14380 = ((_e14350 - (_e14360 * _e14355)) * _e14377);
let _e14383 = (((_e14360 * _e14350) - _e14355) * _e14377);
let _e14389 = select(0f, _e14380, (((_e14383 >= 0f) && (_e14383 < _e691)) && (_e14380 > 0f)));
let _e14391 = (_e14255 << bitcast<u32>(_e13881));
if _e14103 {
phi_39427_ = (_e13897.member - 1i);
} else {
phi_39427_ = _e14102;
}
let _e14406 = phi_39427_;
if _e14258 {
phi_39438_ = (_e13897.member_1 - 1i);
} else {
phi_39438_ = _e14257;
}
let _e14409 = phi_39438_;
let _e14413 = (((f32(_e14406) + 0.5f) * _e13902) - 0.5f);
let _e14417 = (((f32(_e14409) + 0.5f) * _e13902) - 0.5f);
if _e453 {
phi_39466_ = type_23(_e14409, _e14406);
} else {
phi_39466_ = type_23(_e14406, _e14409);
}
let _e14423 = phi_39466_;
if _e13973 {
phi_39517_ = 0u;
} else {
if (_e8554 == 1u) {
phi_39516_ = 0u;
} else {
if (_e8554 == 2u) {
phi_39515_ = _e12623;
} else {
phi_39515_ = select(_e12629, _e12626, (_e8554 == 3u));
}
let _e14431 = phi_39515_;
phi_39516_ = _e14431;
}
let _e14433 = phi_39516_;
phi_39517_ = _e14433;
}
let _e14435 = phi_39517_;
local_80 = (((bitcast<i32>(_e14435) + _e14423.member_1) * _e12620) + _e14423.member);
let _e14440 = local_80;
let _e14442 = select(_e12646, _e14440, (_e14440 < _e12646));
let _e14447 = global_6.member[bitcast<u32>(select(0i, _e14442, (_e14442 > 0i)))];
let _e14452 = (((((select(_e14413, _e14417, _e453) + 0.5f) / _e11769) * 2f) - 1f) * _e11777);
let _e14457 = ((1f - (((select(_e14417, _e14413, _e453) + 0.5f) / _e11770) * 2f)) * _e11785);
let _e14464 = ((_e11788.member * _e14452) + (_e11796.member * _e14457));
let _e14465 = ((_e11788.member_1 * _e14452) + (_e11796.member_1 * _e14457));
let _e14466 = ((_e11788.member_2 * _e14452) + (_e11796.member_2 * _e14457));
let _e14470 = select((_e11811.member + _e14464), _e11811.member, _e11809);
let _e14471 = select((_e11811.member_1 + _e14465), _e11811.member_1, _e11809);
let _e14472 = select((_e11811.member_2 + _e14466), _e11811.member_2, _e11809);
let _e14483 = (((_e14470 * _e14470) + (_e14471 * _e14471)) + (_e14472 * _e14472));
let _e14487 = (1f / sqrt(select(0f, _e14483, (_e14483 > 0f))));
let _e14488 = (_e14470 * _e14487);
let _e14489 = (_e14471 * _e14487);
let _e14490 = (_e14472 * _e14487);
let _e14491 = (_e575 - select(_e11822.member, (_e11822.member + _e14464), _e11809));
let _e14492 = (_e587 - select(_e11822.member_1, (_e11822.member_1 + _e14465), _e11809));
let _e14493 = (_e600 - select(_e11822.member_2, (_e11822.member_2 + _e14466), _e11809));
let _e14498 = (((_e14491 * _e14488) + (_e14492 * _e14489)) + (_e14493 * _e14490));
let _e14503 = (((_e14491 * _e613) + (_e14492 * _e626)) + (_e14493 * _e639));
let _e14508 = (((_e14488 * _e613) + (_e14489 * _e626)) + (_e14490 * _e639));
let _e14511 = ((_e14489 * _e639) - (_e14490 * _e626));
let _e14514 = ((_e14490 * _e613) - (_e14488 * _e639));
let _e14517 = ((_e14488 * _e626) - (_e14489 * _e613));
let _e14522 = (((_e14511 * _e14511) + (_e14514 * _e14514)) + (_e14517 * _e14517));
let _e14525 = (1f / select(1e-9f, _e14522, (_e14522 > 1e-9f)));
let _e14528 = ((_e14498 - (_e14508 * _e14503)) * _e14525);
let _e14531 = (((_e14508 * _e14498) - _e14503) * _e14525);
let _e14537 = select(0f, _e14528, (((_e14531 >= 0f) && (_e14531 < _e691)) && (_e14528 > 0f)));
let _e14539 = (_e14406 << bitcast<u32>(_e13881));
let _e14551 = select(((((_e13880 - select(0f, (_e13942 * _e13943), (((select(select(_e766, _e923, (_e14087 >= _e692)), _e845, (_e14087 < _e298)) == _e8554) && (_e14085 > 0f)) && (_e14085 < _e13995)))) - select(0f, (_e13939 * _e13943), (((select(select(_e766, _e923, (_e14239 >= _e692)), _e845, (_e14239 < _e298)) == _e8554) && (_e14237 > 0f)) && (_e14237 < _e14147)))) - select(0f, (_e13942 * _e13941), (((select(select(_e766, _e923, (_e14391 >= _e692)), _e845, (_e14391 < _e298)) == _e8554) && (_e14389 > 0f)) && (_e14389 < _e14299)))) - select(0f, (_e13939 * _e13941), (((select(select(_e766, _e923, (_e14539 >= _e692)), _e845, (_e14539 < _e298)) == _e8554) && (_e14537 > 0f)) && (_e14537 < _e14447)))), _e13880, _e13973);
if _e453 {
phi_40187_ = type_23(_e11674, _e11581);
} else {
phi_40187_ = type_23(_e11581, _e11674);
}
let _e14566 = phi_40187_;
let _e14569 = (_e11675 && (((_e12537 > 0f) && (_e12537 < _e11765)) && (bitcast<f32>((bitcast<u32>(_e14551) & 2147483647u)) > 1e-6f)));
let _e14572 = global_1.member.member_18.member;
let _e14573 = (((select(_e11700, (1f - _e11700), (_e11685 >= 0f)) - select(_e11719, (1f - _e11719), (_e11704 >= 0f))) * (1f / _e11682)) * _e14572);
let _e14577 = select(0f, (((((_e652 * _e12374.member) * ((1f + (_e12414 * (1f + (_e12414 * (0.5f + (_e12414 * (0.16666667f + (_e12414 * (0.041666668f + (_e12414 * (0.008333334f + (_e12414 * (0.001388889f + (_e12414 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12409 + 127i)) << bitcast<u32>(23i))))) * _e12371) * _e14551) * _e14573), _e14569);
let _e14578 = select(0f, (((((_e665 * _e12374.member_1) * ((1f + (_e12462 * (1f + (_e12462 * (0.5f + (_e12462 * (0.16666667f + (_e12462 * (0.041666668f + (_e12462 * (0.008333334f + (_e12462 * (0.001388889f + (_e12462 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12457 + 127i)) << bitcast<u32>(23i))))) * _e12371) * _e14551) * _e14573), _e14569);
let _e14579 = select(0f, (((((_e678 * _e12374.member_2) * ((1f + (_e12510 * (1f + (_e12510 * (0.5f + (_e12510 * (0.16666667f + (_e12510 * (0.041666668f + (_e12510 * (0.008333334f + (_e12510 * (0.001388889f + (_e12510 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12505 + 127i)) << bitcast<u32>(23i))))) * _e12371) * _e14551) * _e14573), _e14569);
let _e14583 = (bitcast<f32>((bitcast<u32>(_e14577) & 2147483647u)) >= 1073741800f);
let _e14584 = (1f / 1048576f);
let _e14587 = ((_e14577 * select(1f, _e14584, _e14583)) + 0.5f);
let _e14589 = select(-1073741800f, _e14587, (_e14587 > -1073741800f));
let _e14591 = select(1073741800f, _e14589, (_e14589 < 1073741800f));
let _e14598 = select(0i, select(select(i32(_e14591), i32(-2147483648), (_e14591 < -2147483600f)), 2147483647i, (_e14591 > 2147483500f)), (_e14591 == _e14591));
let _e14602 = (_e14598 - select(0i, 1i, (_e14591 < f32(_e14598))));
let _e14603 = select(0i, 20i, _e14583);
let _e14607 = (bitcast<u32>(_e14602) << bitcast<u32>((_e14603 & 31i)));
let _e14614 = bitcast<u32>(((_e14602 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e14603) & 31i))));
let _e14618 = (bitcast<f32>((bitcast<u32>(_e14578) & 2147483647u)) >= 1073741800f);
let _e14621 = ((_e14578 * select(1f, _e14584, _e14618)) + 0.5f);
let _e14623 = select(-1073741800f, _e14621, (_e14621 > -1073741800f));
let _e14625 = select(1073741800f, _e14623, (_e14623 < 1073741800f));
let _e14632 = select(0i, select(select(i32(_e14625), i32(-2147483648), (_e14625 < -2147483600f)), 2147483647i, (_e14625 > 2147483500f)), (_e14625 == _e14625));
let _e14636 = (_e14632 - select(0i, 1i, (_e14625 < f32(_e14632))));
let _e14637 = select(0i, 20i, _e14618);
let _e14641 = (bitcast<u32>(_e14636) << bitcast<u32>((_e14637 & 31i)));
let _e14648 = bitcast<u32>(((_e14636 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e14637) & 31i))));
let _e14652 = (bitcast<f32>((bitcast<u32>(_e14579) & 2147483647u)) >= 1073741800f);
let _e14655 = ((_e14579 * select(1f, _e14584, _e14652)) + 0.5f);
let _e14657 = select(-1073741800f, _e14655, (_e14655 > -1073741800f));
let _e14659 = select(1073741800f, _e14657, (_e14657 < 1073741800f));
let _e14666 = select(0i, select(select(i32(_e14659), i32(-2147483648), (_e14659 < -2147483600f)), 2147483647i, (_e14659 > 2147483500f)), (_e14659 == _e14659));
let _e14670 = (_e14666 - select(0i, 1i, (_e14659 < f32(_e14666))));
let _e14671 = select(0i, 20i, _e14652);
let _e14675 = (bitcast<u32>(_e14670) << bitcast<u32>((_e14671 & 31i)));
let _e14682 = bitcast<u32>(((_e14670 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e14671) & 31i))));
let _e14687 = bitcast<i32>(bitcast<u32>((((_e14566.member_1 * _e931) + _e14566.member) * 6i)));
if ((_e14607 | _e14614) == 0u) {
} else {
let _e14690 = bitcast<u32>(_e14687);
if (_e14690 < _e270) {
let _e14694 = atomicAdd((&global_8.member[_e14690]), _e14607);
phi_40420_ = _e14694;
} else {
phi_40420_ = 0u;
}
let _e14696 = phi_40420_;
let _e14700 = (_e14614 + select(0u, 1u, ((_e14696 + _e14607) < _e14607)));
if (_e14700 == 0u) {
} else {
let _e14702 = (_e14690 + 1u);
if (_e14702 < _e270) {
let _e14706 = atomicAdd((&global_8.member[_e14702]), _e14700);
}
}
}
if ((_e14641 | _e14648) == 0u) {
} else {
let _e14710 = bitcast<u32>((_e14687 + 2i));
if (_e14710 < _e270) {
let _e14714 = atomicAdd((&global_8.member[_e14710]), _e14641);
phi_40450_ = _e14714;
} else {
phi_40450_ = 0u;
}
let _e14716 = phi_40450_;
let _e14720 = (_e14648 + select(0u, 1u, ((_e14716 + _e14641) < _e14641)));
if (_e14720 == 0u) {
} else {
let _e14722 = (_e14710 + 1u);
if (_e14722 < _e270) {
let _e14726 = atomicAdd((&global_8.member[_e14722]), _e14720);
}
}
}
if ((_e14675 | _e14682) == 0u) {
} else {
let _e14730 = bitcast<u32>((_e14687 + 4i));
if (_e14730 < _e270) {
let _e14734 = atomicAdd((&global_8.member[_e14730]), _e14675);
phi_40480_ = _e14734;
} else {
phi_40480_ = 0u;
}
let _e14736 = phi_40480_;
let _e14740 = (_e14682 + select(0u, 1u, ((_e14736 + _e14675) < _e14675)));
if (_e14740 == 0u) {
} else {
let _e14742 = (_e14730 + 1u);
if (_e14742 < _e270) {
let _e14746 = atomicAdd((&global_8.member[_e14742]), _e14740);
}
}
}
phi_29498_ = (_e11672 + 1i);
} else {
phi_29498_ = i32();
}
let _e14749 = phi_29498_;
continue;
continuing {
phi_29497_ = _e14749;
break if !(_e11675);
}
}
phi_29344_ = (_e11578 + 1i);
} else {
phi_29344_ = i32();
}
let _e14753 = phi_29344_;
continue;
continuing {
phi_29343_ = _e14753;
break if !(_e11579);
}
}
}
}
}
}
} else {
let _e14757 = global_1.member.member_1.member;
let _e14760 = global_1.member.member_1.member_1;
let _e14761 = bitcast<i32>(_e14757);
let _e14762 = bitcast<i32>(_e14760);
if _e453 {
phi_40547_ = type_23(_e14762, _e14761);
} else {
phi_40547_ = type_23(_e14761, _e14762);
}
let _e14766 = phi_40547_;
let _e14770 = f32((_e298 + 15i));
let _e14772 = select(_e14770, _e378, (_e378 < _e14770));
let _e14774 = select(_e314, _e14772, (_e14772 > _e314));
let _e14776 = select(_e14770, _e14774, (_e14774 < _e14770));
let _e14783 = select(0i, select(select(i32(_e14776), i32(-2147483648), (_e14776 < -2147483600f)), 2147483647i, (_e14776 > 2147483500f)), (_e14776 == _e14776));
let _e14787 = (_e14783 - select(0i, 1i, (_e14776 < f32(_e14783))));
let _e14788 = bitcast<i32>(_e14787);
let _e14790 = select(_e314, _e365, (_e365 > _e314));
let _e14792 = select(_e314, _e14790, (_e14790 > _e314));
let _e14794 = select(_e14770, _e14792, (_e14792 < _e14770));
let _e14801 = select(0i, select(select(i32(_e14794), i32(-2147483648), (_e14794 < -2147483600f)), 2147483647i, (_e14794 > 2147483500f)), (_e14794 == _e14794));
let _e14805 = (_e14801 - select(0i, 1i, (_e14794 < f32(_e14801))));
let _e14806 = bitcast<i32>(_e14805);
if (_e14788 < _e14766.member) {
phi_40622_ = _e14788;
} else {
phi_40622_ = (_e14766.member - 1i);
}
let _e14810 = phi_40622_;
let _e14811 = (_e14766.member_1 - 1i);
let _e14812 = (_e766 == 0u);
if _e14812 {
let _e14814 = select(_e845, 0u, (_e845 == _e766));
let _e14818 = select(_e923, 0u, ((_e923 == _e766) || (_e923 == _e845)));
let _e14826 = ((select(0u, 1u, (_e766 > 0u)) + select(0u, 1u, (_e14814 > 0u))) + select(0u, 1u, (_e14818 > 0u)));
if (_e14826 == 0u) {
phi_40660_ = 0i;
loop {
let _e14829 = phi_40660_;
let _e14830 = (_e14829 < 16i);
if _e14830 {
let _e14832 = (_e14806 + (_e14829 & 15i));
let _e14836 = (((f32(_e14832) + 0.5f) * 1f) - 0.5f);
let _e14840 = (-(((_e416 * _e14836) + _e442)) / _e429);
let _e14847 = bitcast<f32>((bitcast<u32>(((_e466 * _e14836) + ((_e479 * _e14840) + _e492))) & 2147483647u));
let _e14854 = bitcast<f32>((bitcast<u32>(((_e505 * _e14836) + ((_e518 * _e14840) + _e531))) & 2147483647u));
let _e14858 = (((0.5f * (_e14847 + _e14854)) / _e534) + _e717);
let _e14859 = (1f / 1f);
let _e14867 = ((((_e14840 + _e14858) + 0.5f) * _e14859) - 0.5f);
let _e14868 = f32(_e14811);
let _e14869 = (0f - 1f);
let _e14871 = select(_e14869, _e14867, (_e14867 > _e14869));
let _e14873 = select(_e14868, _e14871, (_e14871 < _e14868));
let _e14880 = select(0i, select(select(i32(_e14873), i32(-2147483648), (_e14873 < -2147483600f)), 2147483647i, (_e14873 > 2147483500f)), (_e14873 == _e14873));
let _e14885 = (((((_e14840 - _e14858) + 0.5f) * _e14859) - 0.5f) + 1f);
let _e14886 = (_e14868 + 1f);
let _e14888 = select(0f, _e14885, (_e14885 > 0f));
let _e14890 = select(_e14886, _e14888, (_e14888 < _e14886));
let _e14897 = select(0i, select(select(i32(_e14890), i32(-2147483648), (_e14890 < -2147483600f)), 2147483647i, (_e14890 > 2147483500f)), (_e14890 == _e14890));
let _e14908 = ((1e-4f * 1f) * _e534);
let _e14910 = select(_e14854, _e14847, (_e14847 > _e14854));
let _e14912 = select(_e14908, _e14910, (_e14910 > _e14908));
let _e14914 = select(_e14854, _e14847, (_e14847 < _e14854));
let _e14916 = select(_e14908, _e14914, (_e14914 > _e14908));
let _e14918 = (0.5f * (_e14912 + _e14916));
let _e14919 = (0.5f / _e14916);
let _e14920 = (1f / _e14912);
phi_40814_ = 0i;
loop {
let _e14922 = phi_40814_;
let _e14924 = (((_e14897 - select(0i, 1i, (_e14890 < f32(_e14897)))) + (_e14829 >> bitcast<u32>(4u))) + bitcast<i32>(_e14922));
let _e14925 = (_e14924 <= select(-1i, (_e14880 - select(0i, 1i, (_e14873 < f32(_e14880)))), (_e14832 <= _e14810)));
if _e14925 {
let _e14931 = (((((f32(_e14924) + 0.5f) * 1f) - 0.5f) - _e14840) * _e534);
let _e14932 = (_e534 * 1f);
let _e14934 = (0.5f * _e14932);
let _e14935 = (_e14931 + _e14934);
let _e14936 = -(_e14935);
let _e14939 = (_e14918 - select(_e14936, _e14935, (_e14935 > _e14936)));
let _e14941 = select(0f, _e14939, (_e14939 > 0f));
let _e14943 = select(_e14916, _e14941, (_e14941 < _e14916));
let _e14946 = (_e14939 - _e14916);
let _e14950 = (((_e14943 * (_e14943 * _e14919)) + select(0f, _e14946, (_e14946 > 0f))) * _e14920);
let _e14954 = (_e14931 - _e14934);
let _e14955 = -(_e14954);
let _e14958 = (_e14918 - select(_e14955, _e14954, (_e14954 > _e14955)));
let _e14960 = select(0f, _e14958, (_e14958 > 0f));
let _e14962 = select(_e14916, _e14960, (_e14960 < _e14916));
let _e14965 = (_e14958 - _e14916);
let _e14969 = (((_e14962 * (_e14962 * _e14919)) + select(0f, _e14965, (_e14965 > 0f))) * _e14920);
if _e453 {
phi_40919_ = type_23(_e14924, _e14832);
} else {
phi_40919_ = type_23(_e14832, _e14924);
}
let _e14978 = phi_40919_;
local_78 = bitcast<i32>((_e14757 * _e14760));
local_79 = ((_e14978.member_1 * _e14761) + _e14978.member);
let _e14985 = local_78;
let _e14986 = local_79;
let _e14987 = (_e14985 + _e14986);
let _e14989 = (bitcast<i32>(_e259) - 1i);
let _e14991 = select(_e14989, _e14987, (_e14987 < _e14989));
let _e14996 = global_5.member[bitcast<u32>(select(0i, _e14991, (_e14991 > 0i)))];
let _e14997 = local_79;
let _e14999 = select(_e14989, _e14997, (_e14997 < _e14989));
let _e15004 = global_5.member[bitcast<u32>(select(0i, _e14999, (_e14999 > 0i)))];
let _e15015 = global_1.member.member_2.member;
let _e15016 = (((((f32(_e14978.member) + 0.5f) / f32(_e14761)) * 2f) - 1f) * _e15015);
let _e15023 = global_1.member.member_2.member_1;
let _e15024 = ((1f - (((f32(_e14978.member_1) + 0.5f) / f32(_e14762)) * 2f)) * _e15023);
let _e15026 = global_1.member.member_3;
let _e15034 = global_1.member.member_4;
let _e15041 = ((_e15026.member * _e15016) + (_e15034.member * _e15024));
let _e15042 = ((_e15026.member_1 * _e15016) + (_e15034.member_1 * _e15024));
let _e15043 = ((_e15026.member_2 * _e15016) + (_e15034.member_2 * _e15024));
let _e15046 = global_1.member.member_2.member_3;
let _e15047 = (_e15046 != 0u);
let _e15049 = global_1.member.member_5;
let _e15056 = select((_e15049.member + _e15041), _e15049.member, _e15047);
let _e15057 = select((_e15049.member_1 + _e15042), _e15049.member_1, _e15047);
let _e15058 = select((_e15049.member_2 + _e15043), _e15049.member_2, _e15047);
let _e15060 = global_1.member.member_6;
let _e15074 = (((_e15056 * _e15056) + (_e15057 * _e15057)) + (_e15058 * _e15058));
let _e15077 = sqrt(select(0f, _e15074, (_e15074 > 0f)));
let _e15078 = (1f / _e15077);
let _e15079 = (_e15056 * _e15078);
let _e15080 = (_e15057 * _e15078);
let _e15081 = (_e15058 * _e15078);
let _e15082 = (_e575 - select(_e15060.member, (_e15060.member + _e15041), _e15047));
let _e15083 = (_e587 - select(_e15060.member_1, (_e15060.member_1 + _e15042), _e15047));
let _e15084 = (_e600 - select(_e15060.member_2, (_e15060.member_2 + _e15043), _e15047));
let _e15089 = (((_e15082 * _e15079) + (_e15083 * _e15080)) + (_e15084 * _e15081));
let _e15094 = (((_e15082 * _e613) + (_e15083 * _e626)) + (_e15084 * _e639));
let _e15099 = (((_e15079 * _e613) + (_e15080 * _e626)) + (_e15081 * _e639));
let _e15102 = ((_e15080 * _e639) - (_e15081 * _e626));
let _e15105 = ((_e15081 * _e613) - (_e15079 * _e639));
let _e15108 = ((_e15079 * _e626) - (_e15080 * _e613));
let _e15113 = (((_e15102 * _e15102) + (_e15105 * _e15105)) + (_e15108 * _e15108));
let _e15116 = (1f / select(1e-9f, _e15113, (_e15113 > 1e-9f)));
let _e15119 = ((_e15089 - (_e15099 * _e15094)) * _e15116);
let _e15122 = (((_e15099 * _e15089) - _e15094) * _e15116);
let _e15128 = -(_e15099);
let _e15131 = global_1.member.member_13.member_2;
let _e15132 = (_e15131 * _e15131);
let _e15136 = ((1f + _e15132) - ((2f * _e15131) * _e15128));
let _e15138 = select(1e-9f, _e15136, (_e15136 > 1e-9f));
let _e15150 = global_1.member.member_13.member_3;
if (_e15150 == 2u) {
let _e15155 = (0.5f - (0.5f * _e15128));
let _e15157 = select(0f, _e15155, (_e15155 > 0f));
let _e15161 = (sqrt(select(0f, _e15157, (_e15157 > 0f))) * 255f);
let _e15162 = (255f - 1f);
let _e15164 = select(0f, _e15161, (_e15161 > 0f));
let _e15166 = select(_e15162, _e15164, (_e15164 < _e15162));
let _e15173 = select(0i, select(select(i32(_e15166), i32(-2147483648), (_e15166 < -2147483600f)), 2147483647i, (_e15166 > 2147483500f)), (_e15166 == _e15166));
let _e15177 = (_e15173 - select(0i, 1i, (_e15166 < f32(_e15173))));
let _e15180 = global_1.member.member_13.member_11;
let _e15181 = bitcast<i32>(_e15180);
let _e15182 = (_e15181 + _e15177);
let _e15184 = (bitcast<i32>(_e265) - 1i);
let _e15186 = select(_e15184, _e15182, (_e15182 < _e15184));
let _e15191 = global_2.member[bitcast<u32>(select(0i, _e15186, (_e15186 > 0i)))];
let _e15193 = (_e15181 + (_e15177 + 1i));
let _e15195 = select(_e15184, _e15193, (_e15193 < _e15184));
let _e15200 = global_2.member[bitcast<u32>(select(0i, _e15195, (_e15195 > 0i)))];
phi_41346_ = (_e15191 + ((_e15200 - _e15191) * (_e15161 - f32(_e15177))));
} else {
phi_41346_ = select(((1f - _e15132) / (_e15138 * sqrt(select(0f, _e15138, (_e15138 > 0f))))), (0.75f * (1f + (_e15128 * _e15128))), (_e15150 == 1u));
}
let _e15207 = phi_41346_;
let _e15210 = (_e15077 * (_e15207 * (0.25f / 3.1415927f)));
let _e15211 = (_e15119 - _e14996);
let _e15214 = (_e15122 + select(0f, _e15211, (_e15211 > 0f)));
let _e15217 = global_1.member.member_13.member_1;
let _e15226 = global_1.member.member_13.member;
let _e15231 = -((_e15226.member * _e15214));
let _e15233 = select(-87f, _e15231, (_e15231 > -87f));
let _e15235 = select(88f, _e15233, (_e15233 < 88f));
let _e15237 = ((_e15235 * 1.442695f) + 0.5f);
let _e15239 = select(-127f, _e15237, (_e15237 > -127f));
let _e15241 = select(128f, _e15239, (_e15239 < 128f));
let _e15248 = select(0i, select(select(i32(_e15241), i32(-2147483648), (_e15241 < -2147483600f)), 2147483647i, (_e15241 > 2147483500f)), (_e15241 == _e15241));
let _e15252 = (_e15248 - select(0i, 1i, (_e15241 < f32(_e15248))));
let _e15253 = f32(_e15252);
let _e15257 = ((_e15235 - (_e15253 * 0.6933594f)) - (_e15253 * -2.1219444e-4f));
let _e15279 = -((_e15226.member_1 * _e15214));
let _e15281 = select(-87f, _e15279, (_e15279 > -87f));
let _e15283 = select(88f, _e15281, (_e15281 < 88f));
let _e15285 = ((_e15283 * 1.442695f) + 0.5f);
let _e15287 = select(-127f, _e15285, (_e15285 > -127f));
let _e15289 = select(128f, _e15287, (_e15287 < 128f));
let _e15296 = select(0i, select(select(i32(_e15289), i32(-2147483648), (_e15289 < -2147483600f)), 2147483647i, (_e15289 > 2147483500f)), (_e15289 == _e15289));
let _e15300 = (_e15296 - select(0i, 1i, (_e15289 < f32(_e15296))));
let _e15301 = f32(_e15300);
let _e15305 = ((_e15283 - (_e15301 * 0.6933594f)) - (_e15301 * -2.1219444e-4f));
let _e15327 = -((_e15226.member_2 * _e15214));
let _e15329 = select(-87f, _e15327, (_e15327 > -87f));
let _e15331 = select(88f, _e15329, (_e15329 < 88f));
let _e15333 = ((_e15331 * 1.442695f) + 0.5f);
let _e15335 = select(-127f, _e15333, (_e15333 > -127f));
let _e15337 = select(128f, _e15335, (_e15335 < 128f));
let _e15344 = select(0i, select(select(i32(_e15337), i32(-2147483648), (_e15337 < -2147483600f)), 2147483647i, (_e15337 > 2147483500f)), (_e15337 == _e15337));
let _e15348 = (_e15344 - select(0i, 1i, (_e15337 < f32(_e15344))));
let _e15349 = f32(_e15348);
let _e15353 = ((_e15331 - (_e15349 * 0.6933594f)) - (_e15349 * -2.1219444e-4f));
let _e15380 = select(0f, _e15119, (((_e15122 >= 0f) && (_e15122 < _e691)) && (_e15119 > 0f)));
if _e453 {
phi_41591_ = type_23(_e14924, _e14832);
} else {
phi_41591_ = type_23(_e14832, _e14924);
}
let _e15391 = phi_41591_;
let _e15394 = (_e14925 && (((_e15380 > 0f) && (_e15380 < _e15004)) && true));
let _e15397 = global_1.member.member_18.member;
let _e15398 = (((select(_e14950, (1f - _e14950), (_e14935 >= 0f)) - select(_e14969, (1f - _e14969), (_e14954 >= 0f))) * (1f / _e14932)) * _e15397);
let _e15402 = select(0f, (((((_e652 * _e15217.member) * ((1f + (_e15257 * (1f + (_e15257 * (0.5f + (_e15257 * (0.16666667f + (_e15257 * (0.041666668f + (_e15257 * (0.008333334f + (_e15257 * (0.001388889f + (_e15257 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e15252 + 127i)) << bitcast<u32>(23i))))) * _e15210) * 1f) * _e15398), _e15394);
let _e15403 = select(0f, (((((_e665 * _e15217.member_1) * ((1f + (_e15305 * (1f + (_e15305 * (0.5f + (_e15305 * (0.16666667f + (_e15305 * (0.041666668f + (_e15305 * (0.008333334f + (_e15305 * (0.001388889f + (_e15305 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e15300 + 127i)) << bitcast<u32>(23i))))) * _e15210) * 1f) * _e15398), _e15394);
let _e15404 = select(0f, (((((_e678 * _e15217.member_2) * ((1f + (_e15353 * (1f + (_e15353 * (0.5f + (_e15353 * (0.16666667f + (_e15353 * (0.041666668f + (_e15353 * (0.008333334f + (_e15353 * (0.001388889f + (_e15353 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e15348 + 127i)) << bitcast<u32>(23i))))) * _e15210) * 1f) * _e15398), _e15394);
let _e15408 = (bitcast<f32>((bitcast<u32>(_e15402) & 2147483647u)) >= 1073741800f);
let _e15409 = (1f / 1048576f);
let _e15412 = ((_e15402 * select(1f, _e15409, _e15408)) + 0.5f);
let _e15414 = select(-1073741800f, _e15412, (_e15412 > -1073741800f));
let _e15416 = select(1073741800f, _e15414, (_e15414 < 1073741800f));
let _e15423 = select(0i, select(select(i32(_e15416), i32(-2147483648), (_e15416 < -2147483600f)), 2147483647i, (_e15416 > 2147483500f)), (_e15416 == _e15416));
let _e15427 = (_e15423 - select(0i, 1i, (_e15416 < f32(_e15423))));
let _e15428 = select(0i, 20i, _e15408);
let _e15432 = (bitcast<u32>(_e15427) << bitcast<u32>((_e15428 & 31i)));
let _e15439 = bitcast<u32>(((_e15427 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e15428) & 31i))));
let _e15443 = (bitcast<f32>((bitcast<u32>(_e15403) & 2147483647u)) >= 1073741800f);
let _e15446 = ((_e15403 * select(1f, _e15409, _e15443)) + 0.5f);
let _e15448 = select(-1073741800f, _e15446, (_e15446 > -1073741800f));
let _e15450 = select(1073741800f, _e15448, (_e15448 < 1073741800f));
let _e15457 = select(0i, select(select(i32(_e15450), i32(-2147483648), (_e15450 < -2147483600f)), 2147483647i, (_e15450 > 2147483500f)), (_e15450 == _e15450));
let _e15461 = (_e15457 - select(0i, 1i, (_e15450 < f32(_e15457))));
let _e15462 = select(0i, 20i, _e15443);
let _e15466 = (bitcast<u32>(_e15461) << bitcast<u32>((_e15462 & 31i)));
let _e15473 = bitcast<u32>(((_e15461 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e15462) & 31i))));
let _e15477 = (bitcast<f32>((bitcast<u32>(_e15404) & 2147483647u)) >= 1073741800f);
let _e15480 = ((_e15404 * select(1f, _e15409, _e15477)) + 0.5f);
let _e15482 = select(-1073741800f, _e15480, (_e15480 > -1073741800f));
let _e15484 = select(1073741800f, _e15482, (_e15482 < 1073741800f));
let _e15491 = select(0i, select(select(i32(_e15484), i32(-2147483648), (_e15484 < -2147483600f)), 2147483647i, (_e15484 > 2147483500f)), (_e15484 == _e15484));
let _e15495 = (_e15491 - select(0i, 1i, (_e15484 < f32(_e15491))));
let _e15496 = select(0i, 20i, _e15477);
let _e15500 = (bitcast<u32>(_e15495) << bitcast<u32>((_e15496 & 31i)));
let _e15507 = bitcast<u32>(((_e15495 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e15496) & 31i))));
let _e15512 = bitcast<i32>(bitcast<u32>((((_e15391.member_1 * _e14761) + _e15391.member) * 6i)));
if ((_e15432 | _e15439) == 0u) {
} else {
let _e15515 = bitcast<u32>(_e15512);
if (_e15515 < _e270) {
let _e15519 = atomicAdd((&global_8.member[_e15515]), _e15432);
phi_41824_ = _e15519;
} else {
phi_41824_ = 0u;
}
let _e15521 = phi_41824_;
let _e15525 = (_e15439 + select(0u, 1u, ((_e15521 + _e15432) < _e15432)));
if (_e15525 == 0u) {
} else {
let _e15527 = (_e15515 + 1u);
if (_e15527 < _e270) {
let _e15531 = atomicAdd((&global_8.member[_e15527]), _e15525);
}
}
}
if ((_e15466 | _e15473) == 0u) {
} else {
let _e15535 = bitcast<u32>((_e15512 + 2i));
if (_e15535 < _e270) {
let _e15539 = atomicAdd((&global_8.member[_e15535]), _e15466);
phi_41854_ = _e15539;
} else {
phi_41854_ = 0u;
}
let _e15541 = phi_41854_;
let _e15545 = (_e15473 + select(0u, 1u, ((_e15541 + _e15466) < _e15466)));
if (_e15545 == 0u) {
} else {
let _e15547 = (_e15535 + 1u);
if (_e15547 < _e270) {
let _e15551 = atomicAdd((&global_8.member[_e15547]), _e15545);
}
}
}
if ((_e15500 | _e15507) == 0u) {
} else {
let _e15555 = bitcast<u32>((_e15512 + 4i));
if (_e15555 < _e270) {
let _e15559 = atomicAdd((&global_8.member[_e15555]), _e15500);
phi_41884_ = _e15559;
} else {
phi_41884_ = 0u;
}
let _e15561 = phi_41884_;
let _e15565 = (_e15507 + select(0u, 1u, ((_e15561 + _e15500) < _e15500)));
if (_e15565 == 0u) {
} else {
let _e15567 = (_e15555 + 1u);
if (_e15567 < _e270) {
let _e15571 = atomicAdd((&global_8.member[_e15567]), _e15565);
}
}
}
phi_40815_ = (_e14922 + 1i);
} else {
phi_40815_ = i32();
}
let _e15574 = phi_40815_;
continue;
continuing {
phi_40814_ = _e15574;
break if !(_e14925);
}
}
phi_40661_ = (_e14829 + 1i);
} else {
phi_40661_ = i32();
}
let _e15578 = phi_40661_;
continue;
continuing {
phi_40660_ = _e15578;
break if !(_e14830);
}
}
} else {
if (_e14826 == 1u) {
phi_41933_ = 0i;
loop {
let _e15582 = phi_41933_;
let _e15583 = (_e15582 < 16i);
if _e15583 {
let _e15585 = (_e14806 + (_e15582 & 15i));
let _e15587 = (f32(_e15585) + 0.5f);
let _e15589 = ((_e15587 * 1f) - 0.5f);
let _e15593 = (-(((_e416 * _e15589) + _e442)) / _e429);
let _e15600 = bitcast<f32>((bitcast<u32>(((_e466 * _e15589) + ((_e479 * _e15593) + _e492))) & 2147483647u));
let _e15607 = bitcast<f32>((bitcast<u32>(((_e505 * _e15589) + ((_e518 * _e15593) + _e531))) & 2147483647u));
let _e15611 = (((0.5f * (_e15600 + _e15607)) / _e534) + _e717);
let _e15612 = (1f / 1f);
let _e15620 = ((((_e15593 + _e15611) + 0.5f) * _e15612) - 0.5f);
let _e15621 = f32(_e14811);
let _e15622 = (0f - 1f);
let _e15624 = select(_e15622, _e15620, (_e15620 > _e15622));
let _e15626 = select(_e15621, _e15624, (_e15624 < _e15621));
let _e15633 = select(0i, select(select(i32(_e15626), i32(-2147483648), (_e15626 < -2147483600f)), 2147483647i, (_e15626 > 2147483500f)), (_e15626 == _e15626));
let _e15638 = (((((_e15593 - _e15611) + 0.5f) * _e15612) - 0.5f) + 1f);
let _e15639 = (_e15621 + 1f);
let _e15641 = select(0f, _e15638, (_e15638 > 0f));
let _e15643 = select(_e15639, _e15641, (_e15641 < _e15639));
let _e15650 = select(0i, select(select(i32(_e15643), i32(-2147483648), (_e15643 < -2147483600f)), 2147483647i, (_e15643 > 2147483500f)), (_e15643 == _e15643));
let _e15661 = ((1e-4f * 1f) * _e534);
let _e15663 = select(_e15607, _e15600, (_e15600 > _e15607));
let _e15665 = select(_e15661, _e15663, (_e15663 > _e15661));
let _e15667 = select(_e15607, _e15600, (_e15600 < _e15607));
let _e15669 = select(_e15661, _e15667, (_e15667 > _e15661));
let _e15671 = (0.5f * (_e15665 + _e15669));
let _e15672 = (0.5f / _e15669);
let _e15673 = (1f / _e15665);
phi_42087_ = 0i;
loop {
let _e15675 = phi_42087_;
let _e15677 = (((_e15650 - select(0i, 1i, (_e15643 < f32(_e15650)))) + (_e15582 >> bitcast<u32>(4u))) + bitcast<i32>(_e15675));
let _e15678 = (_e15677 <= select(-1i, (_e15633 - select(0i, 1i, (_e15626 < f32(_e15633)))), (_e15585 <= _e14810)));
if _e15678 {
let _e15680 = (f32(_e15677) + 0.5f);
let _e15684 = ((((_e15680 * 1f) - 0.5f) - _e15593) * _e534);
let _e15685 = (_e534 * 1f);
let _e15687 = (0.5f * _e15685);
let _e15688 = (_e15684 + _e15687);
let _e15689 = -(_e15688);
let _e15692 = (_e15671 - select(_e15689, _e15688, (_e15688 > _e15689)));
let _e15694 = select(0f, _e15692, (_e15692 > 0f));
let _e15696 = select(_e15669, _e15694, (_e15694 < _e15669));
let _e15699 = (_e15692 - _e15669);
let _e15703 = (((_e15696 * (_e15696 * _e15672)) + select(0f, _e15699, (_e15699 > 0f))) * _e15673);
let _e15707 = (_e15684 - _e15687);
let _e15708 = -(_e15707);
let _e15711 = (_e15671 - select(_e15708, _e15707, (_e15707 > _e15708)));
let _e15713 = select(0f, _e15711, (_e15711 > 0f));
let _e15715 = select(_e15669, _e15713, (_e15713 < _e15669));
let _e15718 = (_e15711 - _e15669);
let _e15722 = (((_e15715 * (_e15715 * _e15672)) + select(0f, _e15718, (_e15718 > 0f))) * _e15673);
if _e453 {
phi_42192_ = type_23(_e15677, _e15585);
} else {
phi_42192_ = type_23(_e15585, _e15677);
}
let _e15731 = phi_42192_;
local_76 = bitcast<i32>((_e14757 * _e14760));
local_77 = ((_e15731.member_1 * _e14761) + _e15731.member);
let _e15738 = local_76;
let _e15739 = local_77;
let _e15740 = (_e15738 + _e15739);
let _e15742 = (bitcast<i32>(_e259) - 1i);
let _e15744 = select(_e15742, _e15740, (_e15740 < _e15742));
let _e15749 = global_5.member[bitcast<u32>(select(0i, _e15744, (_e15744 > 0i)))];
let _e15750 = local_77;
let _e15752 = select(_e15742, _e15750, (_e15750 < _e15742));
let _e15757 = global_5.member[bitcast<u32>(select(0i, _e15752, (_e15752 > 0i)))];
let _e15760 = f32(_e14761);
let _e15761 = f32(_e14762);
let _e15768 = global_1.member.member_2.member;
let _e15769 = (((((f32(_e15731.member) + 0.5f) / _e15760) * 2f) - 1f) * _e15768);
let _e15776 = global_1.member.member_2.member_1;
let _e15777 = ((1f - (((f32(_e15731.member_1) + 0.5f) / _e15761) * 2f)) * _e15776);
let _e15779 = global_1.member.member_3;
let _e15787 = global_1.member.member_4;
let _e15794 = ((_e15779.member * _e15769) + (_e15787.member * _e15777));
let _e15795 = ((_e15779.member_1 * _e15769) + (_e15787.member_1 * _e15777));
let _e15796 = ((_e15779.member_2 * _e15769) + (_e15787.member_2 * _e15777));
let _e15799 = global_1.member.member_2.member_3;
let _e15800 = (_e15799 != 0u);
let _e15802 = global_1.member.member_5;
let _e15809 = select((_e15802.member + _e15794), _e15802.member, _e15800);
let _e15810 = select((_e15802.member_1 + _e15795), _e15802.member_1, _e15800);
let _e15811 = select((_e15802.member_2 + _e15796), _e15802.member_2, _e15800);
let _e15813 = global_1.member.member_6;
let _e15827 = (((_e15809 * _e15809) + (_e15810 * _e15810)) + (_e15811 * _e15811));
let _e15830 = sqrt(select(0f, _e15827, (_e15827 > 0f)));
let _e15831 = (1f / _e15830);
let _e15832 = (_e15809 * _e15831);
let _e15833 = (_e15810 * _e15831);
let _e15834 = (_e15811 * _e15831);
let _e15835 = (_e575 - select(_e15813.member, (_e15813.member + _e15794), _e15800));
let _e15836 = (_e587 - select(_e15813.member_1, (_e15813.member_1 + _e15795), _e15800));
let _e15837 = (_e600 - select(_e15813.member_2, (_e15813.member_2 + _e15796), _e15800));
let _e15842 = (((_e15835 * _e15832) + (_e15836 * _e15833)) + (_e15837 * _e15834));
let _e15847 = (((_e15835 * _e613) + (_e15836 * _e626)) + (_e15837 * _e639));
let _e15852 = (((_e15832 * _e613) + (_e15833 * _e626)) + (_e15834 * _e639));
let _e15855 = ((_e15833 * _e639) - (_e15834 * _e626));
let _e15858 = ((_e15834 * _e613) - (_e15832 * _e639));
let _e15861 = ((_e15832 * _e626) - (_e15833 * _e613));
let _e15866 = (((_e15855 * _e15855) + (_e15858 * _e15858)) + (_e15861 * _e15861));
let _e15869 = (1f / select(1e-9f, _e15866, (_e15866 > 1e-9f)));
let _e15872 = ((_e15842 - (_e15852 * _e15847)) * _e15869);
let _e15875 = (((_e15852 * _e15842) - _e15847) * _e15869);
let _e15881 = -(_e15852);
let _e15884 = global_1.member.member_13.member_2;
let _e15885 = (_e15884 * _e15884);
let _e15889 = ((1f + _e15885) - ((2f * _e15884) * _e15881));
let _e15891 = select(1e-9f, _e15889, (_e15889 > 1e-9f));
let _e15903 = global_1.member.member_13.member_3;
if (_e15903 == 2u) {
let _e15908 = (0.5f - (0.5f * _e15881));
let _e15910 = select(0f, _e15908, (_e15908 > 0f));
let _e15914 = (sqrt(select(0f, _e15910, (_e15910 > 0f))) * 255f);
let _e15915 = (255f - 1f);
let _e15917 = select(0f, _e15914, (_e15914 > 0f));
let _e15919 = select(_e15915, _e15917, (_e15917 < _e15915));
let _e15926 = select(0i, select(select(i32(_e15919), i32(-2147483648), (_e15919 < -2147483600f)), 2147483647i, (_e15919 > 2147483500f)), (_e15919 == _e15919));
let _e15930 = (_e15926 - select(0i, 1i, (_e15919 < f32(_e15926))));
let _e15933 = global_1.member.member_13.member_11;
let _e15934 = bitcast<i32>(_e15933);
let _e15935 = (_e15934 + _e15930);
let _e15937 = (bitcast<i32>(_e265) - 1i);
let _e15939 = select(_e15937, _e15935, (_e15935 < _e15937));
let _e15944 = global_2.member[bitcast<u32>(select(0i, _e15939, (_e15939 > 0i)))];
let _e15946 = (_e15934 + (_e15930 + 1i));
let _e15948 = select(_e15937, _e15946, (_e15946 < _e15937));
let _e15953 = global_2.member[bitcast<u32>(select(0i, _e15948, (_e15948 > 0i)))];
phi_42619_ = (_e15944 + ((_e15953 - _e15944) * (_e15914 - f32(_e15930))));
} else {
phi_42619_ = select(((1f - _e15885) / (_e15891 * sqrt(select(0f, _e15891, (_e15891 > 0f))))), (0.75f * (1f + (_e15881 * _e15881))), (_e15903 == 1u));
}
let _e15960 = phi_42619_;
let _e15963 = (_e15830 * (_e15960 * (0.25f / 3.1415927f)));
let _e15964 = (_e15872 - _e15749);
let _e15967 = (_e15875 + select(0f, _e15964, (_e15964 > 0f)));
let _e15970 = global_1.member.member_13.member_1;
let _e15979 = global_1.member.member_13.member;
let _e15984 = -((_e15979.member * _e15967));
let _e15986 = select(-87f, _e15984, (_e15984 > -87f));
let _e15988 = select(88f, _e15986, (_e15986 < 88f));
let _e15990 = ((_e15988 * 1.442695f) + 0.5f);
let _e15992 = select(-127f, _e15990, (_e15990 > -127f));
let _e15994 = select(128f, _e15992, (_e15992 < 128f));
let _e16001 = select(0i, select(select(i32(_e15994), i32(-2147483648), (_e15994 < -2147483600f)), 2147483647i, (_e15994 > 2147483500f)), (_e15994 == _e15994));
let _e16005 = (_e16001 - select(0i, 1i, (_e15994 < f32(_e16001))));
let _e16006 = f32(_e16005);
let _e16010 = ((_e15988 - (_e16006 * 0.6933594f)) - (_e16006 * -2.1219444e-4f));
let _e16032 = -((_e15979.member_1 * _e15967));
let _e16034 = select(-87f, _e16032, (_e16032 > -87f));
let _e16036 = select(88f, _e16034, (_e16034 < 88f));
let _e16038 = ((_e16036 * 1.442695f) + 0.5f);
let _e16040 = select(-127f, _e16038, (_e16038 > -127f));
let _e16042 = select(128f, _e16040, (_e16040 < 128f));
let _e16049 = select(0i, select(select(i32(_e16042), i32(-2147483648), (_e16042 < -2147483600f)), 2147483647i, (_e16042 > 2147483500f)), (_e16042 == _e16042));
let _e16053 = (_e16049 - select(0i, 1i, (_e16042 < f32(_e16049))));
let _e16054 = f32(_e16053);
let _e16058 = ((_e16036 - (_e16054 * 0.6933594f)) - (_e16054 * -2.1219444e-4f));
let _e16080 = -((_e15979.member_2 * _e15967));
let _e16082 = select(-87f, _e16080, (_e16080 > -87f));
let _e16084 = select(88f, _e16082, (_e16082 < 88f));
let _e16086 = ((_e16084 * 1.442695f) + 0.5f);
let _e16088 = select(-127f, _e16086, (_e16086 > -127f));
let _e16090 = select(128f, _e16088, (_e16088 < 128f));
let _e16097 = select(0i, select(select(i32(_e16090), i32(-2147483648), (_e16090 < -2147483600f)), 2147483647i, (_e16090 > 2147483500f)), (_e16090 == _e16090));
let _e16101 = (_e16097 - select(0i, 1i, (_e16090 < f32(_e16097))));
let _e16102 = f32(_e16101);
let _e16106 = ((_e16084 - (_e16102 * 0.6933594f)) - (_e16102 * -2.1219444e-4f));
let _e16133 = select(0f, _e15872, (((_e15875 >= 0f) && (_e15875 < _e691)) && (_e15872 > 0f)));
let _e16135 = ((_e766 + _e14814) + _e14818);
let _e16136 = (_e16135 & 31u);
let _e16138 = (1u << bitcast<u32>(_e16136));
let _e16147 = bitcast<i32>((((_e14757 + _e16138) - 1u) >> bitcast<u32>(_e16136)));
let _e16148 = bitcast<i32>((((_e14760 + _e16138) - 1u) >> bitcast<u32>(_e16136)));
if _e453 {
phi_42890_ = type_23(_e16148, _e16147);
} else {
phi_42890_ = type_23(_e16147, _e16148);
}
let _e16152 = phi_42890_;
let _e16157 = f32((1i << bitcast<u32>(_e16136)));
let _e16158 = (1f / _e16157);
let _e16160 = ((_e15587 * _e16158) - 0.5f);
let _e16162 = ((_e15680 * _e16158) - 0.5f);
let _e16164 = select(-1f, _e16160, (_e16160 > -1f));
let _e16166 = select(1e6f, _e16164, (_e16164 < 1e6f));
let _e16173 = select(0i, select(select(i32(_e16166), i32(-2147483648), (_e16166 < -2147483600f)), 2147483647i, (_e16166 > 2147483500f)), (_e16166 == _e16166));
let _e16177 = (_e16173 - select(0i, 1i, (_e16166 < f32(_e16173))));
let _e16179 = select(-1f, _e16162, (_e16162 > -1f));
let _e16181 = select(1e6f, _e16179, (_e16179 < 1e6f));
let _e16188 = select(0i, select(select(i32(_e16181), i32(-2147483648), (_e16181 < -2147483600f)), 2147483647i, (_e16181 > 2147483500f)), (_e16181 == _e16181));
let _e16192 = (_e16188 - select(0i, 1i, (_e16181 < f32(_e16188))));
let _e16194 = (_e16160 - f32(_e16177));
let _e16196 = (_e16162 - f32(_e16192));
let _e16197 = (1f - _e16194);
let _e16198 = (1f - _e16196);
let _e16201 = select(_e16177, 0i, (_e16177 < 0i));
let _e16202 = (_e16201 >= _e16152.member);
if _e16202 {
phi_42968_ = (_e16152.member - 1i);
} else {
phi_42968_ = _e16201;
}
let _e16205 = phi_42968_;
let _e16207 = select(_e16192, 0i, (_e16192 < 0i));
let _e16208 = (_e16207 >= _e16152.member_1);
if _e16208 {
phi_42979_ = (_e16152.member_1 - 1i);
} else {
phi_42979_ = _e16207;
}
let _e16211 = phi_42979_;
let _e16215 = (((f32(_e16205) + 0.5f) * _e16157) - 0.5f);
let _e16219 = (((f32(_e16211) + 0.5f) * _e16157) - 0.5f);
if _e453 {
phi_43007_ = type_23(_e16211, _e16205);
} else {
phi_43007_ = type_23(_e16205, _e16211);
}
let _e16225 = phi_43007_;
let _e16231 = bitcast<i32>(((_e14757 + 1u) >> bitcast<u32>(1u)));
let _e16234 = global_1.member.member_18.member_6;
let _e16237 = global_1.member.member_18.member_7;
let _e16240 = global_1.member.member_18.member_8;
let _e16241 = (_e16135 == 0u);
if _e16241 {
phi_43058_ = 0u;
} else {
if (_e16135 == 1u) {
phi_43057_ = 0u;
} else {
if (_e16135 == 2u) {
phi_43056_ = _e16234;
} else {
phi_43056_ = select(_e16240, _e16237, (_e16135 == 3u));
}
let _e16247 = phi_43056_;
phi_43057_ = _e16247;
}
let _e16249 = phi_43057_;
phi_43058_ = _e16249;
}
let _e16251 = phi_43058_;
local_74 = (((bitcast<i32>(_e16251) + _e16225.member_1) * _e16231) + _e16225.member);
let _e16256 = local_74;
let _e16258 = (bitcast<i32>(_e262) - 1i);
let _e16260 = select(_e16258, _e16256, (_e16256 < _e16258));
let _e16265 = global_6.member[bitcast<u32>(select(0i, _e16260, (_e16260 > 0i)))];
let _e16270 = (((((select(_e16215, _e16219, _e453) + 0.5f) / _e15760) * 2f) - 1f) * _e15768);
let _e16275 = ((1f - (((select(_e16219, _e16215, _e453) + 0.5f) / _e15761) * 2f)) * _e15776);
let _e16282 = ((_e15779.member * _e16270) + (_e15787.member * _e16275));
let _e16283 = ((_e15779.member_1 * _e16270) + (_e15787.member_1 * _e16275));
let _e16284 = ((_e15779.member_2 * _e16270) + (_e15787.member_2 * _e16275));
let _e16288 = select((_e15802.member + _e16282), _e15802.member, _e15800);
let _e16289 = select((_e15802.member_1 + _e16283), _e15802.member_1, _e15800);
let _e16290 = select((_e15802.member_2 + _e16284), _e15802.member_2, _e15800);
let _e16301 = (((_e16288 * _e16288) + (_e16289 * _e16289)) + (_e16290 * _e16290));
let _e16305 = (1f / sqrt(select(0f, _e16301, (_e16301 > 0f))));
let _e16306 = (_e16288 * _e16305);
let _e16307 = (_e16289 * _e16305);
let _e16308 = (_e16290 * _e16305);
let _e16309 = (_e575 - select(_e15813.member, (_e15813.member + _e16282), _e15800));
let _e16310 = (_e587 - select(_e15813.member_1, (_e15813.member_1 + _e16283), _e15800));
let _e16311 = (_e600 - select(_e15813.member_2, (_e15813.member_2 + _e16284), _e15800));
let _e16316 = (((_e16309 * _e16306) + (_e16310 * _e16307)) + (_e16311 * _e16308));
let _e16321 = (((_e16309 * _e613) + (_e16310 * _e626)) + (_e16311 * _e639));
let _e16326 = (((_e16306 * _e613) + (_e16307 * _e626)) + (_e16308 * _e639));
let _e16329 = ((_e16307 * _e639) - (_e16308 * _e626));
let _e16332 = ((_e16308 * _e613) - (_e16306 * _e639));
let _e16335 = ((_e16306 * _e626) - (_e16307 * _e613));
let _e16340 = (((_e16329 * _e16329) + (_e16332 * _e16332)) + (_e16335 * _e16335));
let _e16343 = (1f / select(1e-9f, _e16340, (_e16340 > 1e-9f)));
let _e16346 = ((_e16316 - (_e16326 * _e16321)) * _e16343);
let _e16349 = (((_e16326 * _e16316) - _e16321) * _e16343);
let _e16355 = select(0f, _e16346, (((_e16349 >= 0f) && (_e16349 < _e691)) && (_e16346 > 0f)));
let _e16357 = (_e16205 << bitcast<u32>(_e16136));
let _e16369 = (_e16177 + 1i);
let _e16372 = select(_e16369, 0i, (_e16369 < 0i));
let _e16373 = (_e16372 >= _e16152.member);
if _e16373 {
phi_43719_ = (_e16152.member - 1i);
} else {
phi_43719_ = _e16372;
}
let _e16376 = phi_43719_;
if _e16208 {
phi_43730_ = (_e16152.member_1 - 1i);
} else {
phi_43730_ = _e16207;
}
let _e16379 = phi_43730_;
let _e16383 = (((f32(_e16376) + 0.5f) * _e16157) - 0.5f);
let _e16387 = (((f32(_e16379) + 0.5f) * _e16157) - 0.5f);
if _e453 {
phi_43758_ = type_23(_e16379, _e16376);
} else {
phi_43758_ = type_23(_e16376, _e16379);
}
let _e16393 = phi_43758_;
if _e16241 {
phi_43809_ = 0u;
} else {
if (_e16135 == 1u) {
phi_43808_ = 0u;
} else {
if (_e16135 == 2u) {
phi_43807_ = _e16234;
} else {
phi_43807_ = select(_e16240, _e16237, (_e16135 == 3u));
}
let _e16401 = phi_43807_;
phi_43808_ = _e16401;
}
let _e16403 = phi_43808_;
phi_43809_ = _e16403;
}
let _e16405 = phi_43809_;
local_72 = (((bitcast<i32>(_e16405) + _e16393.member_1) * _e16231) + _e16393.member);
let _e16410 = local_72;
let _e16412 = select(_e16258, _e16410, (_e16410 < _e16258));
let _e16417 = global_6.member[bitcast<u32>(select(0i, _e16412, (_e16412 > 0i)))];
let _e16422 = (((((select(_e16383, _e16387, _e453) + 0.5f) / _e15760) * 2f) - 1f) * _e15768);
let _e16427 = ((1f - (((select(_e16387, _e16383, _e453) + 0.5f) / _e15761) * 2f)) * _e15776);
let _e16434 = ((_e15779.member * _e16422) + (_e15787.member * _e16427));
let _e16435 = ((_e15779.member_1 * _e16422) + (_e15787.member_1 * _e16427));
let _e16436 = ((_e15779.member_2 * _e16422) + (_e15787.member_2 * _e16427));
let _e16440 = select((_e15802.member + _e16434), _e15802.member, _e15800);
let _e16441 = select((_e15802.member_1 + _e16435), _e15802.member_1, _e15800);
let _e16442 = select((_e15802.member_2 + _e16436), _e15802.member_2, _e15800);
let _e16453 = (((_e16440 * _e16440) + (_e16441 * _e16441)) + (_e16442 * _e16442));
let _e16457 = (1f / sqrt(select(0f, _e16453, (_e16453 > 0f))));
let _e16458 = (_e16440 * _e16457);
let _e16459 = (_e16441 * _e16457);
let _e16460 = (_e16442 * _e16457);
let _e16461 = (_e575 - select(_e15813.member, (_e15813.member + _e16434), _e15800));
let _e16462 = (_e587 - select(_e15813.member_1, (_e15813.member_1 + _e16435), _e15800));
let _e16463 = (_e600 - select(_e15813.member_2, (_e15813.member_2 + _e16436), _e15800));
let _e16468 = (((_e16461 * _e16458) + (_e16462 * _e16459)) + (_e16463 * _e16460));
let _e16473 = (((_e16461 * _e613) + (_e16462 * _e626)) + (_e16463 * _e639));
let _e16478 = (((_e16458 * _e613) + (_e16459 * _e626)) + (_e16460 * _e639));
let _e16481 = ((_e16459 * _e639) - (_e16460 * _e626));
let _e16484 = ((_e16460 * _e613) - (_e16458 * _e639));
let _e16487 = ((_e16458 * _e626) - (_e16459 * _e613));
let _e16492 = (((_e16481 * _e16481) + (_e16484 * _e16484)) + (_e16487 * _e16487));
let _e16495 = (1f / select(1e-9f, _e16492, (_e16492 > 1e-9f)));
let _e16498 = ((_e16468 - (_e16478 * _e16473)) * _e16495);
let _e16501 = (((_e16478 * _e16468) - _e16473) * _e16495);
let _e16507 = select(0f, _e16498, (((_e16501 >= 0f) && (_e16501 < _e691)) && (_e16498 > 0f)));
let _e16509 = (_e16376 << bitcast<u32>(_e16136));
let _e16521 = (_e16192 + 1i);
if _e16202 {
phi_44470_ = (_e16152.member - 1i);
} else {
phi_44470_ = _e16201;
}
let _e16525 = phi_44470_;
let _e16527 = select(_e16521, 0i, (_e16521 < 0i));
let _e16528 = (_e16527 >= _e16152.member_1);
if _e16528 {
phi_44481_ = (_e16152.member_1 - 1i);
} else {
phi_44481_ = _e16527;
}
let _e16531 = phi_44481_;
let _e16535 = (((f32(_e16525) + 0.5f) * _e16157) - 0.5f);
let _e16539 = (((f32(_e16531) + 0.5f) * _e16157) - 0.5f);
if _e453 {
phi_44509_ = type_23(_e16531, _e16525);
} else {
phi_44509_ = type_23(_e16525, _e16531);
}
let _e16545 = phi_44509_;
if _e16241 {
phi_44560_ = 0u;
} else {
if (_e16135 == 1u) {
phi_44559_ = 0u;
} else {
if (_e16135 == 2u) {
phi_44558_ = _e16234;
} else {
phi_44558_ = select(_e16240, _e16237, (_e16135 == 3u));
}
let _e16553 = phi_44558_;
phi_44559_ = _e16553;
}
let _e16555 = phi_44559_;
phi_44560_ = _e16555;
}
let _e16557 = phi_44560_;
local_70 = (((bitcast<i32>(_e16557) + _e16545.member_1) * _e16231) + _e16545.member);
let _e16562 = local_70;
let _e16564 = select(_e16258, _e16562, (_e16562 < _e16258));
let _e16569 = global_6.member[bitcast<u32>(select(0i, _e16564, (_e16564 > 0i)))];
let _e16574 = (((((select(_e16535, _e16539, _e453) + 0.5f) / _e15760) * 2f) - 1f) * _e15768);
let _e16579 = ((1f - (((select(_e16539, _e16535, _e453) + 0.5f) / _e15761) * 2f)) * _e15776);
let _e16586 = ((_e15779.member * _e16574) + (_e15787.member * _e16579));
let _e16587 = ((_e15779.member_1 * _e16574) + (_e15787.member_1 * _e16579));
let _e16588 = ((_e15779.member_2 * _e16574) + (_e15787.member_2 * _e16579));
let _e16592 = select((_e15802.member + _e16586), _e15802.member, _e15800);
let _e16593 = select((_e15802.member_1 + _e16587), _e15802.member_1, _e15800);
let _e16594 = select((_e15802.member_2 + _e16588), _e15802.member_2, _e15800);
let _e16605 = (((_e16592 * _e16592) + (_e16593 * _e16593)) + (_e16594 * _e16594));
let _e16609 = (1f / sqrt(select(0f, _e16605, (_e16605 > 0f))));
let _e16610 = (_e16592 * _e16609);
let _e16611 = (_e16593 * _e16609);
let _e16612 = (_e16594 * _e16609);
let _e16613 = (_e575 - select(_e15813.member, (_e15813.member + _e16586), _e15800));
let _e16614 = (_e587 - select(_e15813.member_1, (_e15813.member_1 + _e16587), _e15800));
let _e16615 = (_e600 - select(_e15813.member_2, (_e15813.member_2 + _e16588), _e15800));
let _e16620 = (((_e16613 * _e16610) + (_e16614 * _e16611)) + (_e16615 * _e16612));
let _e16625 = (((_e16613 * _e613) + (_e16614 * _e626)) + (_e16615 * _e639));
let _e16630 = (((_e16610 * _e613) + (_e16611 * _e626)) + (_e16612 * _e639));
let _e16633 = ((_e16611 * _e639) - (_e16612 * _e626));
let _e16636 = ((_e16612 * _e613) - (_e16610 * _e639));
let _e16639 = ((_e16610 * _e626) - (_e16611 * _e613));
let _e16644 = (((_e16633 * _e16633) + (_e16636 * _e16636)) + (_e16639 * _e16639));
let _e16647 = (1f / select(1e-9f, _e16644, (_e16644 > 1e-9f)));
let _e16650 = ((_e16620 - (_e16630 * _e16625)) * _e16647);
let _e16653 = (((_e16630 * _e16620) - _e16625) * _e16647);
let _e16659 = select(0f, _e16650, (((_e16653 >= 0f) && (_e16653 < _e691)) && (_e16650 > 0f)));
let _e16661 = (_e16525 << bitcast<u32>(_e16136));
if _e16373 {
phi_45221_ = (_e16152.member - 1i);
} else {
phi_45221_ = _e16372;
}
let _e16676 = phi_45221_;
if _e16528 {
phi_45232_ = (_e16152.member_1 - 1i);
} else {
phi_45232_ = _e16527;
}
let _e16679 = phi_45232_;
let _e16683 = (((f32(_e16676) + 0.5f) * _e16157) - 0.5f);
let _e16687 = (((f32(_e16679) + 0.5f) * _e16157) - 0.5f);
if _e453 {
phi_45260_ = type_23(_e16679, _e16676);
} else {
phi_45260_ = type_23(_e16676, _e16679);
}
let _e16693 = phi_45260_;
if _e16241 {
phi_45311_ = 0u;
} else {
if (_e16135 == 1u) {
phi_45310_ = 0u;
} else {
if (_e16135 == 2u) {
phi_45309_ = _e16234;
} else {
phi_45309_ = select(_e16240, _e16237, (_e16135 == 3u));
}
let _e16701 = phi_45309_;
phi_45310_ = _e16701;
}
let _e16703 = phi_45310_;
phi_45311_ = _e16703;
}
let _e16705 = phi_45311_;
local_68 = (((bitcast<i32>(_e16705) + _e16693.member_1) * _e16231) + _e16693.member);
let _e16710 = local_68;
let _e16712 = select(_e16258, _e16710, (_e16710 < _e16258));
let _e16717 = global_6.member[bitcast<u32>(select(0i, _e16712, (_e16712 > 0i)))];
let _e16722 = (((((select(_e16683, _e16687, _e453) + 0.5f) / _e15760) * 2f) - 1f) * _e15768);
let _e16727 = ((1f - (((select(_e16687, _e16683, _e453) + 0.5f) / _e15761) * 2f)) * _e15776);
let _e16734 = ((_e15779.member * _e16722) + (_e15787.member * _e16727));
let _e16735 = ((_e15779.member_1 * _e16722) + (_e15787.member_1 * _e16727));
let _e16736 = ((_e15779.member_2 * _e16722) + (_e15787.member_2 * _e16727));
let _e16740 = select((_e15802.member + _e16734), _e15802.member, _e15800);
let _e16741 = select((_e15802.member_1 + _e16735), _e15802.member_1, _e15800);
let _e16742 = select((_e15802.member_2 + _e16736), _e15802.member_2, _e15800);
let _e16753 = (((_e16740 * _e16740) + (_e16741 * _e16741)) + (_e16742 * _e16742));
let _e16757 = (1f / sqrt(select(0f, _e16753, (_e16753 > 0f))));
let _e16758 = (_e16740 * _e16757);
let _e16759 = (_e16741 * _e16757);
let _e16760 = (_e16742 * _e16757);
let _e16761 = (_e575 - select(_e15813.member, (_e15813.member + _e16734), _e15800));
let _e16762 = (_e587 - select(_e15813.member_1, (_e15813.member_1 + _e16735), _e15800));
let _e16763 = (_e600 - select(_e15813.member_2, (_e15813.member_2 + _e16736), _e15800));
let _e16768 = (((_e16761 * _e16758) + (_e16762 * _e16759)) + (_e16763 * _e16760));
let _e16773 = (((_e16761 * _e613) + (_e16762 * _e626)) + (_e16763 * _e639));
let _e16778 = (((_e16758 * _e613) + (_e16759 * _e626)) + (_e16760 * _e639));
let _e16781 = ((_e16759 * _e639) - (_e16760 * _e626));
let _e16784 = ((_e16760 * _e613) - (_e16758 * _e639));
let _e16787 = ((_e16758 * _e626) - (_e16759 * _e613));
let _e16792 = (((_e16781 * _e16781) + (_e16784 * _e16784)) + (_e16787 * _e16787));
let _e16795 = (1f / select(1e-9f, _e16792, (_e16792 > 1e-9f)));
let _e16798 = ((_e16768 - (_e16778 * _e16773)) * _e16795);
let _e16801 = (((_e16778 * _e16768) - _e16773) * _e16795);
let _e16807 = select(0f, _e16798, (((_e16801 >= 0f) && (_e16801 < _e691)) && (_e16798 > 0f)));
let _e16809 = (_e16676 << bitcast<u32>(_e16136));
let _e16821 = select(((((1f - select(0f, (_e16197 * _e16198), (((select(select(_e766, _e923, (_e16357 >= _e692)), _e845, (_e16357 < _e298)) == _e16135) && (_e16355 > 0f)) && (_e16355 < _e16265)))) - select(0f, (_e16194 * _e16198), (((select(select(_e766, _e923, (_e16509 >= _e692)), _e845, (_e16509 < _e298)) == _e16135) && (_e16507 > 0f)) && (_e16507 < _e16417)))) - select(0f, (_e16197 * _e16196), (((select(select(_e766, _e923, (_e16661 >= _e692)), _e845, (_e16661 < _e298)) == _e16135) && (_e16659 > 0f)) && (_e16659 < _e16569)))) - select(0f, (_e16194 * _e16196), (((select(select(_e766, _e923, (_e16809 >= _e692)), _e845, (_e16809 < _e298)) == _e16135) && (_e16807 > 0f)) && (_e16807 < _e16717)))), 1f, _e16241);
if _e453 {
phi_45981_ = type_23(_e15677, _e15585);
} else {
phi_45981_ = type_23(_e15585, _e15677);
}
let _e16836 = phi_45981_;
let _e16839 = (_e15678 && (((_e16133 > 0f) && (_e16133 < _e15757)) && (bitcast<f32>((bitcast<u32>(_e16821) & 2147483647u)) > 1e-6f)));
let _e16842 = global_1.member.member_18.member;
let _e16843 = (((select(_e15703, (1f - _e15703), (_e15688 >= 0f)) - select(_e15722, (1f - _e15722), (_e15707 >= 0f))) * (1f / _e15685)) * _e16842);
let _e16847 = select(0f, (((((_e652 * _e15970.member) * ((1f + (_e16010 * (1f + (_e16010 * (0.5f + (_e16010 * (0.16666667f + (_e16010 * (0.041666668f + (_e16010 * (0.008333334f + (_e16010 * (0.001388889f + (_e16010 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e16005 + 127i)) << bitcast<u32>(23i))))) * _e15963) * _e16821) * _e16843), _e16839);
let _e16848 = select(0f, (((((_e665 * _e15970.member_1) * ((1f + (_e16058 * (1f + (_e16058 * (0.5f + (_e16058 * (0.16666667f + (_e16058 * (0.041666668f + (_e16058 * (0.008333334f + (_e16058 * (0.001388889f + (_e16058 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e16053 + 127i)) << bitcast<u32>(23i))))) * _e15963) * _e16821) * _e16843), _e16839);
let _e16849 = select(0f, (((((_e678 * _e15970.member_2) * ((1f + (_e16106 * (1f + (_e16106 * (0.5f + (_e16106 * (0.16666667f + (_e16106 * (0.041666668f + (_e16106 * (0.008333334f + (_e16106 * (0.001388889f + (_e16106 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e16101 + 127i)) << bitcast<u32>(23i))))) * _e15963) * _e16821) * _e16843), _e16839);
let _e16853 = (bitcast<f32>((bitcast<u32>(_e16847) & 2147483647u)) >= 1073741800f);
let _e16854 = (1f / 1048576f);
let _e16857 = ((_e16847 * select(1f, _e16854, _e16853)) + 0.5f);
let _e16859 = select(-1073741800f, _e16857, (_e16857 > -1073741800f));
let _e16861 = select(1073741800f, _e16859, (_e16859 < 1073741800f));
let _e16868 = select(0i, select(select(i32(_e16861), i32(-2147483648), (_e16861 < -2147483600f)), 2147483647i, (_e16861 > 2147483500f)), (_e16861 == _e16861));
let _e16872 = (_e16868 - select(0i, 1i, (_e16861 < f32(_e16868))));
let _e16873 = select(0i, 20i, _e16853);
let _e16877 = (bitcast<u32>(_e16872) << bitcast<u32>((_e16873 & 31i)));
let _e16884 = bitcast<u32>(((_e16872 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16873) & 31i))));
let _e16888 = (bitcast<f32>((bitcast<u32>(_e16848) & 2147483647u)) >= 1073741800f);
let _e16891 = ((_e16848 * select(1f, _e16854, _e16888)) + 0.5f);
let _e16893 = select(-1073741800f, _e16891, (_e16891 > -1073741800f));
let _e16895 = select(1073741800f, _e16893, (_e16893 < 1073741800f));
let _e16902 = select(0i, select(select(i32(_e16895), i32(-2147483648), (_e16895 < -2147483600f)), 2147483647i, (_e16895 > 2147483500f)), (_e16895 == _e16895));
let _e16906 = (_e16902 - select(0i, 1i, (_e16895 < f32(_e16902))));
let _e16907 = select(0i, 20i, _e16888);
let _e16911 = (bitcast<u32>(_e16906) << bitcast<u32>((_e16907 & 31i)));
let _e16918 = bitcast<u32>(((_e16906 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16907) & 31i))));
let _e16922 = (bitcast<f32>((bitcast<u32>(_e16849) & 2147483647u)) >= 1073741800f);
let _e16925 = ((_e16849 * select(1f, _e16854, _e16922)) + 0.5f);
let _e16927 = select(-1073741800f, _e16925, (_e16925 > -1073741800f));
let _e16929 = select(1073741800f, _e16927, (_e16927 < 1073741800f));
let _e16936 = select(0i, select(select(i32(_e16929), i32(-2147483648), (_e16929 < -2147483600f)), 2147483647i, (_e16929 > 2147483500f)), (_e16929 == _e16929));
let _e16940 = (_e16936 - select(0i, 1i, (_e16929 < f32(_e16936))));
let _e16941 = select(0i, 20i, _e16922);
let _e16945 = (bitcast<u32>(_e16940) << bitcast<u32>((_e16941 & 31i)));
let _e16952 = bitcast<u32>(((_e16940 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16941) & 31i))));
let _e16957 = bitcast<i32>(bitcast<u32>((((_e16836.member_1 * _e14761) + _e16836.member) * 6i)));
if ((_e16877 | _e16884) == 0u) {
} else {
let _e16960 = bitcast<u32>(_e16957);
if (_e16960 < _e270) {
let _e16964 = atomicAdd((&global_8.member[_e16960]), _e16877);
phi_46214_ = _e16964;
} else {
phi_46214_ = 0u;
}
let _e16966 = phi_46214_;
let _e16970 = (_e16884 + select(0u, 1u, ((_e16966 + _e16877) < _e16877)));
if (_e16970 == 0u) {
} else {
let _e16972 = (_e16960 + 1u);
if (_e16972 < _e270) {
let _e16976 = atomicAdd((&global_8.member[_e16972]), _e16970);
}
}
}
if ((_e16911 | _e16918) == 0u) {
} else {
let _e16980 = bitcast<u32>((_e16957 + 2i));
if (_e16980 < _e270) {
let _e16984 = atomicAdd((&global_8.member[_e16980]), _e16911);
phi_46244_ = _e16984;
} else {
phi_46244_ = 0u;
}
let _e16986 = phi_46244_;
let _e16990 = (_e16918 + select(0u, 1u, ((_e16986 + _e16911) < _e16911)));
if (_e16990 == 0u) {
} else {
let _e16992 = (_e16980 + 1u);
if (_e16992 < _e270) {
let _e16996 = atomicAdd((&global_8.member[_e16992]), _e16990);
}
}
}
if ((_e16945 | _e16952) == 0u) {
} else {
let _e17000 = bitcast<u32>((_e16957 + 4i));
if (_e17000 < _e270) {
let _e17004 = atomicAdd((&global_8.member[_e17000]), _e16945);
phi_46274_ = _e17004;
} else {
phi_46274_ = 0u;
}
let _e17006 = phi_46274_;
let _e17010 = (_e16952 + select(0u, 1u, ((_e17006 + _e16945) < _e16945)));
if (_e17010 == 0u) {
} else {
let _e17012 = (_e17000 + 1u);
if (_e17012 < _e270) {
let _e17016 = atomicAdd((&global_8.member[_e17012]), _e17010);
}
}
}
phi_42088_ = (_e15675 + 1i);
} else {
phi_42088_ = i32();
}
let _e17019 = phi_42088_;
continue;
continuing {
phi_42087_ = _e17019;
break if !(_e15678);
}
}
phi_41934_ = (_e15582 + 1i);
} else {
phi_41934_ = i32();
}
let _e17023 = phi_41934_;
continue;
continuing {
phi_41933_ = _e17023;
break if !(_e15583);
}
}
} else {
phi_46319_ = 0i;
loop {
let _e17026 = phi_46319_;
let _e17027 = (_e17026 < 16i);
if _e17027 {
let _e17029 = (_e14806 + (_e17026 & 15i));
let _e17031 = (f32(_e17029) + 0.5f);
let _e17033 = ((_e17031 * 1f) - 0.5f);
let _e17037 = (-(((_e416 * _e17033) + _e442)) / _e429);
let _e17044 = bitcast<f32>((bitcast<u32>(((_e466 * _e17033) + ((_e479 * _e17037) + _e492))) & 2147483647u));
let _e17051 = bitcast<f32>((bitcast<u32>(((_e505 * _e17033) + ((_e518 * _e17037) + _e531))) & 2147483647u));
let _e17055 = (((0.5f * (_e17044 + _e17051)) / _e534) + _e717);
let _e17056 = (1f / 1f);
let _e17064 = ((((_e17037 + _e17055) + 0.5f) * _e17056) - 0.5f);
let _e17065 = f32(_e14811);
let _e17066 = (0f - 1f);
let _e17068 = select(_e17066, _e17064, (_e17064 > _e17066));
let _e17070 = select(_e17065, _e17068, (_e17068 < _e17065));
let _e17077 = select(0i, select(select(i32(_e17070), i32(-2147483648), (_e17070 < -2147483600f)), 2147483647i, (_e17070 > 2147483500f)), (_e17070 == _e17070));
let _e17082 = (((((_e17037 - _e17055) + 0.5f) * _e17056) - 0.5f) + 1f);
let _e17083 = (_e17065 + 1f);
let _e17085 = select(0f, _e17082, (_e17082 > 0f));
let _e17087 = select(_e17083, _e17085, (_e17085 < _e17083));
let _e17094 = select(0i, select(select(i32(_e17087), i32(-2147483648), (_e17087 < -2147483600f)), 2147483647i, (_e17087 > 2147483500f)), (_e17087 == _e17087));
let _e17105 = ((1e-4f * 1f) * _e534);
let _e17107 = select(_e17051, _e17044, (_e17044 > _e17051));
let _e17109 = select(_e17105, _e17107, (_e17107 > _e17105));
let _e17111 = select(_e17051, _e17044, (_e17044 < _e17051));
let _e17113 = select(_e17105, _e17111, (_e17111 > _e17105));
let _e17115 = (0.5f * (_e17109 + _e17113));
let _e17116 = (0.5f / _e17113);
let _e17117 = (1f / _e17109);
phi_46473_ = 0i;
loop {
let _e17119 = phi_46473_;
let _e17121 = (((_e17094 - select(0i, 1i, (_e17087 < f32(_e17094)))) + (_e17026 >> bitcast<u32>(4u))) + bitcast<i32>(_e17119));
let _e17122 = (_e17121 <= select(-1i, (_e17077 - select(0i, 1i, (_e17070 < f32(_e17077)))), (_e17029 <= _e14810)));
if _e17122 {
let _e17124 = (f32(_e17121) + 0.5f);
let _e17128 = ((((_e17124 * 1f) - 0.5f) - _e17037) * _e534);
let _e17129 = (_e534 * 1f);
let _e17131 = (0.5f * _e17129);
let _e17132 = (_e17128 + _e17131);
let _e17133 = -(_e17132);
let _e17136 = (_e17115 - select(_e17133, _e17132, (_e17132 > _e17133)));
let _e17138 = select(0f, _e17136, (_e17136 > 0f));
let _e17140 = select(_e17113, _e17138, (_e17138 < _e17113));
let _e17143 = (_e17136 - _e17113);
let _e17147 = (((_e17140 * (_e17140 * _e17116)) + select(0f, _e17143, (_e17143 > 0f))) * _e17117);
let _e17151 = (_e17128 - _e17131);
let _e17152 = -(_e17151);
let _e17155 = (_e17115 - select(_e17152, _e17151, (_e17151 > _e17152)));
let _e17157 = select(0f, _e17155, (_e17155 > 0f));
let _e17159 = select(_e17113, _e17157, (_e17157 < _e17113));
let _e17162 = (_e17155 - _e17113);
let _e17166 = (((_e17159 * (_e17159 * _e17116)) + select(0f, _e17162, (_e17162 > 0f))) * _e17117);
if _e453 {
phi_46578_ = type_23(_e17121, _e17029);
} else {
phi_46578_ = type_23(_e17029, _e17121);
}
let _e17175 = phi_46578_;
local_66 = bitcast<i32>((_e14757 * _e14760));
local_67 = ((_e17175.member_1 * _e14761) + _e17175.member);
let _e17182 = local_66;
let _e17183 = local_67;
let _e17184 = (_e17182 + _e17183);
let _e17186 = (bitcast<i32>(_e259) - 1i);
let _e17188 = select(_e17186, _e17184, (_e17184 < _e17186));
let _e17193 = global_5.member[bitcast<u32>(select(0i, _e17188, (_e17188 > 0i)))];
let _e17194 = local_67;
let _e17196 = select(_e17186, _e17194, (_e17194 < _e17186));
let _e17201 = global_5.member[bitcast<u32>(select(0i, _e17196, (_e17196 > 0i)))];
let _e17204 = f32(_e14761);
let _e17205 = f32(_e14762);
let _e17212 = global_1.member.member_2.member;
let _e17213 = (((((f32(_e17175.member) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e17220 = global_1.member.member_2.member_1;
let _e17221 = ((1f - (((f32(_e17175.member_1) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e17223 = global_1.member.member_3;
let _e17231 = global_1.member.member_4;
let _e17238 = ((_e17223.member * _e17213) + (_e17231.member * _e17221));
let _e17239 = ((_e17223.member_1 * _e17213) + (_e17231.member_1 * _e17221));
let _e17240 = ((_e17223.member_2 * _e17213) + (_e17231.member_2 * _e17221));
let _e17243 = global_1.member.member_2.member_3;
let _e17244 = (_e17243 != 0u);
let _e17246 = global_1.member.member_5;
let _e17253 = select((_e17246.member + _e17238), _e17246.member, _e17244);
let _e17254 = select((_e17246.member_1 + _e17239), _e17246.member_1, _e17244);
let _e17255 = select((_e17246.member_2 + _e17240), _e17246.member_2, _e17244);
let _e17257 = global_1.member.member_6;
let _e17271 = (((_e17253 * _e17253) + (_e17254 * _e17254)) + (_e17255 * _e17255));
let _e17274 = sqrt(select(0f, _e17271, (_e17271 > 0f)));
let _e17275 = (1f / _e17274);
let _e17276 = (_e17253 * _e17275);
let _e17277 = (_e17254 * _e17275);
let _e17278 = (_e17255 * _e17275);
let _e17279 = (_e575 - select(_e17257.member, (_e17257.member + _e17238), _e17244));
let _e17280 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e17239), _e17244));
let _e17281 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e17240), _e17244));
let _e17286 = (((_e17279 * _e17276) + (_e17280 * _e17277)) + (_e17281 * _e17278));
let _e17291 = (((_e17279 * _e613) + (_e17280 * _e626)) + (_e17281 * _e639));
let _e17296 = (((_e17276 * _e613) + (_e17277 * _e626)) + (_e17278 * _e639));
let _e17299 = ((_e17277 * _e639) - (_e17278 * _e626));
let _e17302 = ((_e17278 * _e613) - (_e17276 * _e639));
let _e17305 = ((_e17276 * _e626) - (_e17277 * _e613));
let _e17310 = (((_e17299 * _e17299) + (_e17302 * _e17302)) + (_e17305 * _e17305));
let _e17313 = (1f / select(1e-9f, _e17310, (_e17310 > 1e-9f)));
let _e17316 = ((_e17286 - (_e17296 * _e17291)) * _e17313);
let _e17319 = (((_e17296 * _e17286) - _e17291) * _e17313);
let _e17325 = -(_e17296);
let _e17328 = global_1.member.member_13.member_2;
let _e17329 = (_e17328 * _e17328);
let _e17333 = ((1f + _e17329) - ((2f * _e17328) * _e17325));
let _e17335 = select(1e-9f, _e17333, (_e17333 > 1e-9f));
let _e17347 = global_1.member.member_13.member_3;
if (_e17347 == 2u) {
let _e17352 = (0.5f - (0.5f * _e17325));
let _e17354 = select(0f, _e17352, (_e17352 > 0f));
let _e17358 = (sqrt(select(0f, _e17354, (_e17354 > 0f))) * 255f);
let _e17359 = (255f - 1f);
let _e17361 = select(0f, _e17358, (_e17358 > 0f));
let _e17363 = select(_e17359, _e17361, (_e17361 < _e17359));
let _e17370 = select(0i, select(select(i32(_e17363), i32(-2147483648), (_e17363 < -2147483600f)), 2147483647i, (_e17363 > 2147483500f)), (_e17363 == _e17363));
let _e17374 = (_e17370 - select(0i, 1i, (_e17363 < f32(_e17370))));
let _e17377 = global_1.member.member_13.member_11;
let _e17378 = bitcast<i32>(_e17377);
let _e17379 = (_e17378 + _e17374);
let _e17381 = (bitcast<i32>(_e265) - 1i);
let _e17383 = select(_e17381, _e17379, (_e17379 < _e17381));
let _e17388 = global_2.member[bitcast<u32>(select(0i, _e17383, (_e17383 > 0i)))];
let _e17390 = (_e17378 + (_e17374 + 1i));
let _e17392 = select(_e17381, _e17390, (_e17390 < _e17381));
let _e17397 = global_2.member[bitcast<u32>(select(0i, _e17392, (_e17392 > 0i)))];
phi_47005_ = (_e17388 + ((_e17397 - _e17388) * (_e17358 - f32(_e17374))));
} else {
phi_47005_ = select(((1f - _e17329) / (_e17335 * sqrt(select(0f, _e17335, (_e17335 > 0f))))), (0.75f * (1f + (_e17325 * _e17325))), (_e17347 == 1u));
}
let _e17404 = phi_47005_;
let _e17407 = (_e17274 * (_e17404 * (0.25f / 3.1415927f)));
let _e17408 = (_e17316 - _e17193);
let _e17411 = (_e17319 + select(0f, _e17408, (_e17408 > 0f)));
let _e17414 = global_1.member.member_13.member_1;
let _e17423 = global_1.member.member_13.member;
let _e17428 = -((_e17423.member * _e17411));
let _e17430 = select(-87f, _e17428, (_e17428 > -87f));
let _e17432 = select(88f, _e17430, (_e17430 < 88f));
let _e17434 = ((_e17432 * 1.442695f) + 0.5f);
let _e17436 = select(-127f, _e17434, (_e17434 > -127f));
let _e17438 = select(128f, _e17436, (_e17436 < 128f));
let _e17445 = select(0i, select(select(i32(_e17438), i32(-2147483648), (_e17438 < -2147483600f)), 2147483647i, (_e17438 > 2147483500f)), (_e17438 == _e17438));
let _e17449 = (_e17445 - select(0i, 1i, (_e17438 < f32(_e17445))));
let _e17450 = f32(_e17449);
let _e17454 = ((_e17432 - (_e17450 * 0.6933594f)) - (_e17450 * -2.1219444e-4f));
let _e17476 = -((_e17423.member_1 * _e17411));
let _e17478 = select(-87f, _e17476, (_e17476 > -87f));
let _e17480 = select(88f, _e17478, (_e17478 < 88f));
let _e17482 = ((_e17480 * 1.442695f) + 0.5f);
let _e17484 = select(-127f, _e17482, (_e17482 > -127f));
let _e17486 = select(128f, _e17484, (_e17484 < 128f));
let _e17493 = select(0i, select(select(i32(_e17486), i32(-2147483648), (_e17486 < -2147483600f)), 2147483647i, (_e17486 > 2147483500f)), (_e17486 == _e17486));
let _e17497 = (_e17493 - select(0i, 1i, (_e17486 < f32(_e17493))));
let _e17498 = f32(_e17497);
let _e17502 = ((_e17480 - (_e17498 * 0.6933594f)) - (_e17498 * -2.1219444e-4f));
let _e17524 = -((_e17423.member_2 * _e17411));
let _e17526 = select(-87f, _e17524, (_e17524 > -87f));
let _e17528 = select(88f, _e17526, (_e17526 < 88f));
let _e17530 = ((_e17528 * 1.442695f) + 0.5f);
let _e17532 = select(-127f, _e17530, (_e17530 > -127f));
let _e17534 = select(128f, _e17532, (_e17532 < 128f));
let _e17541 = select(0i, select(select(i32(_e17534), i32(-2147483648), (_e17534 < -2147483600f)), 2147483647i, (_e17534 > 2147483500f)), (_e17534 == _e17534));
let _e17545 = (_e17541 - select(0i, 1i, (_e17534 < f32(_e17541))));
let _e17546 = f32(_e17545);
let _e17550 = ((_e17528 - (_e17546 * 0.6933594f)) - (_e17546 * -2.1219444e-4f));
let _e17577 = select(0f, _e17316, (((_e17319 >= 0f) && (_e17319 < _e691)) && (_e17316 > 0f)));
let _e17578 = (_e766 & 31u);
let _e17580 = (1u << bitcast<u32>(_e17578));
let _e17589 = bitcast<i32>((((_e14757 + _e17580) - 1u) >> bitcast<u32>(_e17578)));
let _e17590 = bitcast<i32>((((_e14760 + _e17580) - 1u) >> bitcast<u32>(_e17578)));
if _e453 {
phi_47274_ = type_23(_e17590, _e17589);
} else {
phi_47274_ = type_23(_e17589, _e17590);
}
let _e17594 = phi_47274_;
let _e17599 = f32((1i << bitcast<u32>(_e17578)));
let _e17600 = (1f / _e17599);
let _e17602 = ((_e17031 * _e17600) - 0.5f);
let _e17604 = ((_e17124 * _e17600) - 0.5f);
let _e17606 = select(-1f, _e17602, (_e17602 > -1f));
let _e17608 = select(1e6f, _e17606, (_e17606 < 1e6f));
let _e17615 = select(0i, select(select(i32(_e17608), i32(-2147483648), (_e17608 < -2147483600f)), 2147483647i, (_e17608 > 2147483500f)), (_e17608 == _e17608));
let _e17619 = (_e17615 - select(0i, 1i, (_e17608 < f32(_e17615))));
let _e17621 = select(-1f, _e17604, (_e17604 > -1f));
let _e17623 = select(1e6f, _e17621, (_e17621 < 1e6f));
let _e17630 = select(0i, select(select(i32(_e17623), i32(-2147483648), (_e17623 < -2147483600f)), 2147483647i, (_e17623 > 2147483500f)), (_e17623 == _e17623));
let _e17634 = (_e17630 - select(0i, 1i, (_e17623 < f32(_e17630))));
let _e17636 = (_e17602 - f32(_e17619));
let _e17638 = (_e17604 - f32(_e17634));
let _e17639 = (1f - _e17636);
let _e17640 = (1f - _e17638);
let _e17643 = select(_e17619, 0i, (_e17619 < 0i));
let _e17644 = (_e17643 >= _e17594.member);
if _e17644 {
phi_47352_ = (_e17594.member - 1i);
} else {
phi_47352_ = _e17643;
}
let _e17647 = phi_47352_;
let _e17649 = select(_e17634, 0i, (_e17634 < 0i));
let _e17650 = (_e17649 >= _e17594.member_1);
if _e17650 {
phi_47363_ = (_e17594.member_1 - 1i);
} else {
phi_47363_ = _e17649;
}
let _e17653 = phi_47363_;
let _e17657 = (((f32(_e17647) + 0.5f) * _e17599) - 0.5f);
let _e17661 = (((f32(_e17653) + 0.5f) * _e17599) - 0.5f);
if _e453 {
phi_47391_ = type_23(_e17653, _e17647);
} else {
phi_47391_ = type_23(_e17647, _e17653);
}
let _e17667 = phi_47391_;
let _e17673 = bitcast<i32>(((_e14757 + 1u) >> bitcast<u32>(1u)));
let _e17676 = global_1.member.member_18.member_6;
let _e17679 = global_1.member.member_18.member_7;
let _e17682 = global_1.member.member_18.member_8;
if _e14812 {
phi_47442_ = 0u;
} else {
if (_e766 == 1u) {
phi_47441_ = 0u;
} else {
if (_e766 == 2u) {
phi_47440_ = _e17676;
} else {
phi_47440_ = select(_e17682, _e17679, (_e766 == 3u));
}
let _e17688 = phi_47440_;
phi_47441_ = _e17688;
}
let _e17690 = phi_47441_;
phi_47442_ = _e17690;
}
let _e17692 = phi_47442_;
local_64 = (((bitcast<i32>(_e17692) + _e17667.member_1) * _e17673) + _e17667.member);
let _e17697 = local_64;
let _e17699 = (bitcast<i32>(_e262) - 1i);
let _e17701 = select(_e17699, _e17697, (_e17697 < _e17699));
let _e17706 = global_6.member[bitcast<u32>(select(0i, _e17701, (_e17701 > 0i)))];
let _e17711 = (((((select(_e17657, _e17661, _e453) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e17716 = ((1f - (((select(_e17661, _e17657, _e453) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e17723 = ((_e17223.member * _e17711) + (_e17231.member * _e17716));
let _e17724 = ((_e17223.member_1 * _e17711) + (_e17231.member_1 * _e17716));
let _e17725 = ((_e17223.member_2 * _e17711) + (_e17231.member_2 * _e17716));
let _e17729 = select((_e17246.member + _e17723), _e17246.member, _e17244);
let _e17730 = select((_e17246.member_1 + _e17724), _e17246.member_1, _e17244);
let _e17731 = select((_e17246.member_2 + _e17725), _e17246.member_2, _e17244);
let _e17742 = (((_e17729 * _e17729) + (_e17730 * _e17730)) + (_e17731 * _e17731));
let _e17746 = (1f / sqrt(select(0f, _e17742, (_e17742 > 0f))));
let _e17747 = (_e17729 * _e17746);
let _e17748 = (_e17730 * _e17746);
let _e17749 = (_e17731 * _e17746);
let _e17750 = (_e575 - select(_e17257.member, (_e17257.member + _e17723), _e17244));
let _e17751 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e17724), _e17244));
let _e17752 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e17725), _e17244));
let _e17757 = (((_e17750 * _e17747) + (_e17751 * _e17748)) + (_e17752 * _e17749));
let _e17762 = (((_e17750 * _e613) + (_e17751 * _e626)) + (_e17752 * _e639));
let _e17767 = (((_e17747 * _e613) + (_e17748 * _e626)) + (_e17749 * _e639));
let _e17770 = ((_e17748 * _e639) - (_e17749 * _e626));
let _e17773 = ((_e17749 * _e613) - (_e17747 * _e639));
let _e17776 = ((_e17747 * _e626) - (_e17748 * _e613));
let _e17781 = (((_e17770 * _e17770) + (_e17773 * _e17773)) + (_e17776 * _e17776));
let _e17784 = (1f / select(1e-9f, _e17781, (_e17781 > 1e-9f)));
let _e17787 = ((_e17757 - (_e17767 * _e17762)) * _e17784);
let _e17790 = (((_e17767 * _e17757) - _e17762) * _e17784);
let _e17796 = select(0f, _e17787, (((_e17790 >= 0f) && (_e17790 < _e691)) && (_e17787 > 0f)));
let _e17798 = (_e17647 << bitcast<u32>(_e17578));
let _e17810 = (_e17619 + 1i);
let _e17813 = select(_e17810, 0i, (_e17810 < 0i));
let _e17814 = (_e17813 >= _e17594.member);
if _e17814 {
phi_48103_ = (_e17594.member - 1i);
} else {
phi_48103_ = _e17813;
}
let _e17817 = phi_48103_;
if _e17650 {
phi_48114_ = (_e17594.member_1 - 1i);
} else {
phi_48114_ = _e17649;
}
let _e17820 = phi_48114_;
let _e17824 = (((f32(_e17817) + 0.5f) * _e17599) - 0.5f);
let _e17828 = (((f32(_e17820) + 0.5f) * _e17599) - 0.5f);
if _e453 {
phi_48142_ = type_23(_e17820, _e17817);
} else {
phi_48142_ = type_23(_e17817, _e17820);
}
let _e17834 = phi_48142_;
if _e14812 {
phi_48193_ = 0u;
} else {
if (_e766 == 1u) {
phi_48192_ = 0u;
} else {
if (_e766 == 2u) {
phi_48191_ = _e17676;
} else {
phi_48191_ = select(_e17682, _e17679, (_e766 == 3u));
}
let _e17842 = phi_48191_;
phi_48192_ = _e17842;
}
let _e17844 = phi_48192_;
phi_48193_ = _e17844;
}
let _e17846 = phi_48193_;
local_62 = (((bitcast<i32>(_e17846) + _e17834.member_1) * _e17673) + _e17834.member);
let _e17851 = local_62;
let _e17853 = select(_e17699, _e17851, (_e17851 < _e17699));
let _e17858 = global_6.member[bitcast<u32>(select(0i, _e17853, (_e17853 > 0i)))];
let _e17863 = (((((select(_e17824, _e17828, _e453) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e17868 = ((1f - (((select(_e17828, _e17824, _e453) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e17875 = ((_e17223.member * _e17863) + (_e17231.member * _e17868));
let _e17876 = ((_e17223.member_1 * _e17863) + (_e17231.member_1 * _e17868));
let _e17877 = ((_e17223.member_2 * _e17863) + (_e17231.member_2 * _e17868));
let _e17881 = select((_e17246.member + _e17875), _e17246.member, _e17244);
let _e17882 = select((_e17246.member_1 + _e17876), _e17246.member_1, _e17244);
let _e17883 = select((_e17246.member_2 + _e17877), _e17246.member_2, _e17244);
let _e17894 = (((_e17881 * _e17881) + (_e17882 * _e17882)) + (_e17883 * _e17883));
let _e17898 = (1f / sqrt(select(0f, _e17894, (_e17894 > 0f))));
let _e17899 = (_e17881 * _e17898);
let _e17900 = (_e17882 * _e17898);
let _e17901 = (_e17883 * _e17898);
let _e17902 = (_e575 - select(_e17257.member, (_e17257.member + _e17875), _e17244));
let _e17903 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e17876), _e17244));
let _e17904 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e17877), _e17244));
let _e17909 = (((_e17902 * _e17899) + (_e17903 * _e17900)) + (_e17904 * _e17901));
let _e17914 = (((_e17902 * _e613) + (_e17903 * _e626)) + (_e17904 * _e639));
let _e17919 = (((_e17899 * _e613) + (_e17900 * _e626)) + (_e17901 * _e639));
let _e17922 = ((_e17900 * _e639) - (_e17901 * _e626));
let _e17925 = ((_e17901 * _e613) - (_e17899 * _e639));
let _e17928 = ((_e17899 * _e626) - (_e17900 * _e613));
let _e17933 = (((_e17922 * _e17922) + (_e17925 * _e17925)) + (_e17928 * _e17928));
let _e17936 = (1f / select(1e-9f, _e17933, (_e17933 > 1e-9f)));
let _e17939 = ((_e17909 - (_e17919 * _e17914)) * _e17936);
let _e17942 = (((_e17919 * _e17909) - _e17914) * _e17936);
let _e17948 = select(0f, _e17939, (((_e17942 >= 0f) && (_e17942 < _e691)) && (_e17939 > 0f)));
let _e17950 = (_e17817 << bitcast<u32>(_e17578));
let _e17962 = (_e17634 + 1i);
if _e17644 {
phi_48854_ = (_e17594.member - 1i);
} else {
phi_48854_ = _e17643;
}
let _e17966 = phi_48854_;
let _e17968 = select(_e17962, 0i, (_e17962 < 0i));
let _e17969 = (_e17968 >= _e17594.member_1);
if _e17969 {
phi_48865_ = (_e17594.member_1 - 1i);
} else {
phi_48865_ = _e17968;
}
let _e17972 = phi_48865_;
let _e17976 = (((f32(_e17966) + 0.5f) * _e17599) - 0.5f);
let _e17980 = (((f32(_e17972) + 0.5f) * _e17599) - 0.5f);
if _e453 {
phi_48893_ = type_23(_e17972, _e17966);
} else {
phi_48893_ = type_23(_e17966, _e17972);
}
let _e17986 = phi_48893_;
if _e14812 {
phi_48944_ = 0u;
} else {
if (_e766 == 1u) {
phi_48943_ = 0u;
} else {
if (_e766 == 2u) {
phi_48942_ = _e17676;
} else {
phi_48942_ = select(_e17682, _e17679, (_e766 == 3u));
}
let _e17994 = phi_48942_;
phi_48943_ = _e17994;
}
let _e17996 = phi_48943_;
phi_48944_ = _e17996;
}
let _e17998 = phi_48944_;
local_60 = (((bitcast<i32>(_e17998) + _e17986.member_1) * _e17673) + _e17986.member);
let _e18003 = local_60;
let _e18005 = select(_e17699, _e18003, (_e18003 < _e17699));
let _e18010 = global_6.member[bitcast<u32>(select(0i, _e18005, (_e18005 > 0i)))];
let _e18015 = (((((select(_e17976, _e17980, _e453) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e18020 = ((1f - (((select(_e17980, _e17976, _e453) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e18027 = ((_e17223.member * _e18015) + (_e17231.member * _e18020));
let _e18028 = ((_e17223.member_1 * _e18015) + (_e17231.member_1 * _e18020));
let _e18029 = ((_e17223.member_2 * _e18015) + (_e17231.member_2 * _e18020));
let _e18033 = select((_e17246.member + _e18027), _e17246.member, _e17244);
let _e18034 = select((_e17246.member_1 + _e18028), _e17246.member_1, _e17244);
let _e18035 = select((_e17246.member_2 + _e18029), _e17246.member_2, _e17244);
let _e18046 = (((_e18033 * _e18033) + (_e18034 * _e18034)) + (_e18035 * _e18035));
let _e18050 = (1f / sqrt(select(0f, _e18046, (_e18046 > 0f))));
let _e18051 = (_e18033 * _e18050);
let _e18052 = (_e18034 * _e18050);
let _e18053 = (_e18035 * _e18050);
let _e18054 = (_e575 - select(_e17257.member, (_e17257.member + _e18027), _e17244));
let _e18055 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e18028), _e17244));
let _e18056 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e18029), _e17244));
let _e18061 = (((_e18054 * _e18051) + (_e18055 * _e18052)) + (_e18056 * _e18053));
let _e18066 = (((_e18054 * _e613) + (_e18055 * _e626)) + (_e18056 * _e639));
let _e18071 = (((_e18051 * _e613) + (_e18052 * _e626)) + (_e18053 * _e639));
let _e18074 = ((_e18052 * _e639) - (_e18053 * _e626));
let _e18077 = ((_e18053 * _e613) - (_e18051 * _e639));
let _e18080 = ((_e18051 * _e626) - (_e18052 * _e613));
let _e18085 = (((_e18074 * _e18074) + (_e18077 * _e18077)) + (_e18080 * _e18080));
let _e18088 = (1f / select(1e-9f, _e18085, (_e18085 > 1e-9f)));
let _e18091 = ((_e18061 - (_e18071 * _e18066)) * _e18088);
let _e18094 = (((_e18071 * _e18061) - _e18066) * _e18088);
let _e18100 = select(0f, _e18091, (((_e18094 >= 0f) && (_e18094 < _e691)) && (_e18091 > 0f)));
let _e18102 = (_e17966 << bitcast<u32>(_e17578));
if _e17814 {
phi_49605_ = (_e17594.member - 1i);
} else {
phi_49605_ = _e17813;
}
let _e18117 = phi_49605_;
if _e17969 {
phi_49616_ = (_e17594.member_1 - 1i);
} else {
phi_49616_ = _e17968;
}
let _e18120 = phi_49616_;
let _e18124 = (((f32(_e18117) + 0.5f) * _e17599) - 0.5f);
let _e18128 = (((f32(_e18120) + 0.5f) * _e17599) - 0.5f);
if _e453 {
phi_49644_ = type_23(_e18120, _e18117);
} else {
phi_49644_ = type_23(_e18117, _e18120);
}
let _e18134 = phi_49644_;
if _e14812 {
phi_49695_ = 0u;
} else {
if (_e766 == 1u) {
phi_49694_ = 0u;
} else {
if (_e766 == 2u) {
phi_49693_ = _e17676;
} else {
phi_49693_ = select(_e17682, _e17679, (_e766 == 3u));
}
let _e18142 = phi_49693_;
phi_49694_ = _e18142;
}
let _e18144 = phi_49694_;
phi_49695_ = _e18144;
}
let _e18146 = phi_49695_;
local_58 = (((bitcast<i32>(_e18146) + _e18134.member_1) * _e17673) + _e18134.member);
let _e18151 = local_58;
let _e18153 = select(_e17699, _e18151, (_e18151 < _e17699));
let _e18158 = global_6.member[bitcast<u32>(select(0i, _e18153, (_e18153 > 0i)))];
let _e18163 = (((((select(_e18124, _e18128, _e453) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e18168 = ((1f - (((select(_e18128, _e18124, _e453) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e18175 = ((_e17223.member * _e18163) + (_e17231.member * _e18168));
let _e18176 = ((_e17223.member_1 * _e18163) + (_e17231.member_1 * _e18168));
let _e18177 = ((_e17223.member_2 * _e18163) + (_e17231.member_2 * _e18168));
let _e18181 = select((_e17246.member + _e18175), _e17246.member, _e17244);
let _e18182 = select((_e17246.member_1 + _e18176), _e17246.member_1, _e17244);
let _e18183 = select((_e17246.member_2 + _e18177), _e17246.member_2, _e17244);
let _e18194 = (((_e18181 * _e18181) + (_e18182 * _e18182)) + (_e18183 * _e18183));
let _e18198 = (1f / sqrt(select(0f, _e18194, (_e18194 > 0f))));
let _e18199 = (_e18181 * _e18198);
let _e18200 = (_e18182 * _e18198);
let _e18201 = (_e18183 * _e18198);
let _e18202 = (_e575 - select(_e17257.member, (_e17257.member + _e18175), _e17244));
let _e18203 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e18176), _e17244));
let _e18204 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e18177), _e17244));
let _e18209 = (((_e18202 * _e18199) + (_e18203 * _e18200)) + (_e18204 * _e18201));
let _e18214 = (((_e18202 * _e613) + (_e18203 * _e626)) + (_e18204 * _e639));
let _e18219 = (((_e18199 * _e613) + (_e18200 * _e626)) + (_e18201 * _e639));
let _e18222 = ((_e18200 * _e639) - (_e18201 * _e626));
let _e18225 = ((_e18201 * _e613) - (_e18199 * _e639));
let _e18228 = ((_e18199 * _e626) - (_e18200 * _e613));
let _e18233 = (((_e18222 * _e18222) + (_e18225 * _e18225)) + (_e18228 * _e18228));
let _e18236 = (1f / select(1e-9f, _e18233, (_e18233 > 1e-9f)));
let _e18239 = ((_e18209 - (_e18219 * _e18214)) * _e18236);
let _e18242 = (((_e18219 * _e18209) - _e18214) * _e18236);
let _e18248 = select(0f, _e18239, (((_e18242 >= 0f) && (_e18242 < _e691)) && (_e18239 > 0f)));
let _e18250 = (_e18117 << bitcast<u32>(_e17578));
let _e18262 = select(((((1f - select(0f, (_e17639 * _e17640), (((select(select(_e766, _e923, (_e17798 >= _e692)), _e845, (_e17798 < _e298)) == _e766) && (_e17796 > 0f)) && (_e17796 < _e17706)))) - select(0f, (_e17636 * _e17640), (((select(select(_e766, _e923, (_e17950 >= _e692)), _e845, (_e17950 < _e298)) == _e766) && (_e17948 > 0f)) && (_e17948 < _e17858)))) - select(0f, (_e17639 * _e17638), (((select(select(_e766, _e923, (_e18102 >= _e692)), _e845, (_e18102 < _e298)) == _e766) && (_e18100 > 0f)) && (_e18100 < _e18010)))) - select(0f, (_e17636 * _e17638), (((select(select(_e766, _e923, (_e18250 >= _e692)), _e845, (_e18250 < _e298)) == _e766) && (_e18248 > 0f)) && (_e18248 < _e18158)))), 1f, _e14812);
let _e18263 = (_e14814 & 31u);
let _e18265 = (1u << bitcast<u32>(_e18263));
let _e18274 = bitcast<i32>((((_e14757 + _e18265) - 1u) >> bitcast<u32>(_e18263)));
let _e18275 = bitcast<i32>((((_e14760 + _e18265) - 1u) >> bitcast<u32>(_e18263)));
if _e453 {
phi_50374_ = type_23(_e18275, _e18274);
} else {
phi_50374_ = type_23(_e18274, _e18275);
}
let _e18279 = phi_50374_;
let _e18284 = f32((1i << bitcast<u32>(_e18263)));
let _e18285 = (1f / _e18284);
let _e18287 = ((_e17031 * _e18285) - 0.5f);
let _e18289 = ((_e17124 * _e18285) - 0.5f);
let _e18291 = select(-1f, _e18287, (_e18287 > -1f));
let _e18293 = select(1e6f, _e18291, (_e18291 < 1e6f));
let _e18300 = select(0i, select(select(i32(_e18293), i32(-2147483648), (_e18293 < -2147483600f)), 2147483647i, (_e18293 > 2147483500f)), (_e18293 == _e18293));
let _e18304 = (_e18300 - select(0i, 1i, (_e18293 < f32(_e18300))));
let _e18306 = select(-1f, _e18289, (_e18289 > -1f));
let _e18308 = select(1e6f, _e18306, (_e18306 < 1e6f));
let _e18315 = select(0i, select(select(i32(_e18308), i32(-2147483648), (_e18308 < -2147483600f)), 2147483647i, (_e18308 > 2147483500f)), (_e18308 == _e18308));
let _e18319 = (_e18315 - select(0i, 1i, (_e18308 < f32(_e18315))));
let _e18321 = (_e18287 - f32(_e18304));
let _e18323 = (_e18289 - f32(_e18319));
let _e18324 = (1f - _e18321);
let _e18325 = (1f - _e18323);
let _e18328 = select(_e18304, 0i, (_e18304 < 0i));
let _e18329 = (_e18328 >= _e18279.member);
if _e18329 {
phi_50452_ = (_e18279.member - 1i);
} else {
phi_50452_ = _e18328;
}
let _e18332 = phi_50452_;
let _e18334 = select(_e18319, 0i, (_e18319 < 0i));
let _e18335 = (_e18334 >= _e18279.member_1);
if _e18335 {
phi_50463_ = (_e18279.member_1 - 1i);
} else {
phi_50463_ = _e18334;
}
let _e18338 = phi_50463_;
let _e18342 = (((f32(_e18332) + 0.5f) * _e18284) - 0.5f);
let _e18346 = (((f32(_e18338) + 0.5f) * _e18284) - 0.5f);
if _e453 {
phi_50491_ = type_23(_e18338, _e18332);
} else {
phi_50491_ = type_23(_e18332, _e18338);
}
let _e18352 = phi_50491_;
let _e18355 = (_e14814 == 0u);
if _e18355 {
phi_50542_ = 0u;
} else {
if (_e14814 == 1u) {
phi_50541_ = 0u;
} else {
if (_e14814 == 2u) {
phi_50540_ = _e17676;
} else {
phi_50540_ = select(_e17682, _e17679, (_e14814 == 3u));
}
let _e18361 = phi_50540_;
phi_50541_ = _e18361;
}
let _e18363 = phi_50541_;
phi_50542_ = _e18363;
}
let _e18365 = phi_50542_;
local_56 = (((bitcast<i32>(_e18365) + _e18352.member_1) * _e17673) + _e18352.member);
let _e18370 = local_56;
let _e18372 = select(_e17699, _e18370, (_e18370 < _e17699));
let _e18377 = global_6.member[bitcast<u32>(select(0i, _e18372, (_e18372 > 0i)))];
let _e18382 = (((((select(_e18342, _e18346, _e453) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e18387 = ((1f - (((select(_e18346, _e18342, _e453) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e18394 = ((_e17223.member * _e18382) + (_e17231.member * _e18387));
let _e18395 = ((_e17223.member_1 * _e18382) + (_e17231.member_1 * _e18387));
let _e18396 = ((_e17223.member_2 * _e18382) + (_e17231.member_2 * _e18387));
let _e18400 = select((_e17246.member + _e18394), _e17246.member, _e17244);
let _e18401 = select((_e17246.member_1 + _e18395), _e17246.member_1, _e17244);
let _e18402 = select((_e17246.member_2 + _e18396), _e17246.member_2, _e17244);
let _e18413 = (((_e18400 * _e18400) + (_e18401 * _e18401)) + (_e18402 * _e18402));
let _e18417 = (1f / sqrt(select(0f, _e18413, (_e18413 > 0f))));
let _e18418 = (_e18400 * _e18417);
let _e18419 = (_e18401 * _e18417);
let _e18420 = (_e18402 * _e18417);
let _e18421 = (_e575 - select(_e17257.member, (_e17257.member + _e18394), _e17244));
let _e18422 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e18395), _e17244));
let _e18423 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e18396), _e17244));
let _e18428 = (((_e18421 * _e18418) + (_e18422 * _e18419)) + (_e18423 * _e18420));
let _e18433 = (((_e18421 * _e613) + (_e18422 * _e626)) + (_e18423 * _e639));
let _e18438 = (((_e18418 * _e613) + (_e18419 * _e626)) + (_e18420 * _e639));
let _e18441 = ((_e18419 * _e639) - (_e18420 * _e626));
let _e18444 = ((_e18420 * _e613) - (_e18418 * _e639));
let _e18447 = ((_e18418 * _e626) - (_e18419 * _e613));
let _e18452 = (((_e18441 * _e18441) + (_e18444 * _e18444)) + (_e18447 * _e18447));
let _e18455 = (1f / select(1e-9f, _e18452, (_e18452 > 1e-9f)));
let _e18458 = ((_e18428 - (_e18438 * _e18433)) * _e18455);
let _e18461 = (((_e18438 * _e18428) - _e18433) * _e18455);
let _e18467 = select(0f, _e18458, (((_e18461 >= 0f) && (_e18461 < _e691)) && (_e18458 > 0f)));
let _e18469 = (_e18332 << bitcast<u32>(_e18263));
let _e18481 = (_e18304 + 1i);
let _e18484 = select(_e18481, 0i, (_e18481 < 0i));
let _e18485 = (_e18484 >= _e18279.member);
if _e18485 {
phi_51203_ = (_e18279.member - 1i);
} else {
phi_51203_ = _e18484;
}
let _e18488 = phi_51203_;
if _e18335 {
phi_51214_ = (_e18279.member_1 - 1i);
} else {
phi_51214_ = _e18334;
}
let _e18491 = phi_51214_;
let _e18495 = (((f32(_e18488) + 0.5f) * _e18284) - 0.5f);
let _e18499 = (((f32(_e18491) + 0.5f) * _e18284) - 0.5f);
if _e453 {
phi_51242_ = type_23(_e18491, _e18488);
} else {
phi_51242_ = type_23(_e18488, _e18491);
}
let _e18505 = phi_51242_;
if _e18355 {
phi_51293_ = 0u;
} else {
if (_e14814 == 1u) {
phi_51292_ = 0u;
} else {
if (_e14814 == 2u) {
phi_51291_ = _e17676;
} else {
phi_51291_ = select(_e17682, _e17679, (_e14814 == 3u));
}
let _e18513 = phi_51291_;
phi_51292_ = _e18513;
}
let _e18515 = phi_51292_;
phi_51293_ = _e18515;
}
let _e18517 = phi_51293_;
local_54 = (((bitcast<i32>(_e18517) + _e18505.member_1) * _e17673) + _e18505.member);
let _e18522 = local_54;
let _e18524 = select(_e17699, _e18522, (_e18522 < _e17699));
let _e18529 = global_6.member[bitcast<u32>(select(0i, _e18524, (_e18524 > 0i)))];
let _e18534 = (((((select(_e18495, _e18499, _e453) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e18539 = ((1f - (((select(_e18499, _e18495, _e453) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e18546 = ((_e17223.member * _e18534) + (_e17231.member * _e18539));
let _e18547 = ((_e17223.member_1 * _e18534) + (_e17231.member_1 * _e18539));
let _e18548 = ((_e17223.member_2 * _e18534) + (_e17231.member_2 * _e18539));
let _e18552 = select((_e17246.member + _e18546), _e17246.member, _e17244);
let _e18553 = select((_e17246.member_1 + _e18547), _e17246.member_1, _e17244);
let _e18554 = select((_e17246.member_2 + _e18548), _e17246.member_2, _e17244);
let _e18565 = (((_e18552 * _e18552) + (_e18553 * _e18553)) + (_e18554 * _e18554));
let _e18569 = (1f / sqrt(select(0f, _e18565, (_e18565 > 0f))));
let _e18570 = (_e18552 * _e18569);
let _e18571 = (_e18553 * _e18569);
let _e18572 = (_e18554 * _e18569);
let _e18573 = (_e575 - select(_e17257.member, (_e17257.member + _e18546), _e17244));
let _e18574 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e18547), _e17244));
let _e18575 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e18548), _e17244));
let _e18580 = (((_e18573 * _e18570) + (_e18574 * _e18571)) + (_e18575 * _e18572));
let _e18585 = (((_e18573 * _e613) + (_e18574 * _e626)) + (_e18575 * _e639));
let _e18590 = (((_e18570 * _e613) + (_e18571 * _e626)) + (_e18572 * _e639));
let _e18593 = ((_e18571 * _e639) - (_e18572 * _e626));
let _e18596 = ((_e18572 * _e613) - (_e18570 * _e639));
let _e18599 = ((_e18570 * _e626) - (_e18571 * _e613));
let _e18604 = (((_e18593 * _e18593) + (_e18596 * _e18596)) + (_e18599 * _e18599));
let _e18607 = (1f / select(1e-9f, _e18604, (_e18604 > 1e-9f)));
let _e18610 = ((_e18580 - (_e18590 * _e18585)) * _e18607);
let _e18613 = (((_e18590 * _e18580) - _e18585) * _e18607);
let _e18619 = select(0f, _e18610, (((_e18613 >= 0f) && (_e18613 < _e691)) && (_e18610 > 0f)));
let _e18621 = (_e18488 << bitcast<u32>(_e18263));
let _e18633 = (_e18319 + 1i);
if _e18329 {
phi_51954_ = (_e18279.member - 1i);
} else {
phi_51954_ = _e18328;
}
let _e18637 = phi_51954_;
let _e18639 = select(_e18633, 0i, (_e18633 < 0i));
let _e18640 = (_e18639 >= _e18279.member_1);
if _e18640 {
phi_51965_ = (_e18279.member_1 - 1i);
} else {
phi_51965_ = _e18639;
}
let _e18643 = phi_51965_;
let _e18647 = (((f32(_e18637) + 0.5f) * _e18284) - 0.5f);
let _e18651 = (((f32(_e18643) + 0.5f) * _e18284) - 0.5f);
if _e453 {
phi_51993_ = type_23(_e18643, _e18637);
} else {
phi_51993_ = type_23(_e18637, _e18643);
}
let _e18657 = phi_51993_;
if _e18355 {
phi_52044_ = 0u;
} else {
if (_e14814 == 1u) {
phi_52043_ = 0u;
} else {
if (_e14814 == 2u) {
phi_52042_ = _e17676;
} else {
phi_52042_ = select(_e17682, _e17679, (_e14814 == 3u));
}
let _e18665 = phi_52042_;
phi_52043_ = _e18665;
}
let _e18667 = phi_52043_;
phi_52044_ = _e18667;
}
let _e18669 = phi_52044_;
local_52 = (((bitcast<i32>(_e18669) + _e18657.member_1) * _e17673) + _e18657.member);
let _e18674 = local_52;
let _e18676 = select(_e17699, _e18674, (_e18674 < _e17699));
let _e18681 = global_6.member[bitcast<u32>(select(0i, _e18676, (_e18676 > 0i)))];
let _e18686 = (((((select(_e18647, _e18651, _e453) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e18691 = ((1f - (((select(_e18651, _e18647, _e453) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e18698 = ((_e17223.member * _e18686) + (_e17231.member * _e18691));
let _e18699 = ((_e17223.member_1 * _e18686) + (_e17231.member_1 * _e18691));
let _e18700 = ((_e17223.member_2 * _e18686) + (_e17231.member_2 * _e18691));
let _e18704 = select((_e17246.member + _e18698), _e17246.member, _e17244);
let _e18705 = select((_e17246.member_1 + _e18699), _e17246.member_1, _e17244);
let _e18706 = select((_e17246.member_2 + _e18700), _e17246.member_2, _e17244);
let _e18717 = (((_e18704 * _e18704) + (_e18705 * _e18705)) + (_e18706 * _e18706));
let _e18721 = (1f / sqrt(select(0f, _e18717, (_e18717 > 0f))));
let _e18722 = (_e18704 * _e18721);
let _e18723 = (_e18705 * _e18721);
let _e18724 = (_e18706 * _e18721);
let _e18725 = (_e575 - select(_e17257.member, (_e17257.member + _e18698), _e17244));
let _e18726 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e18699), _e17244));
let _e18727 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e18700), _e17244));
let _e18732 = (((_e18725 * _e18722) + (_e18726 * _e18723)) + (_e18727 * _e18724));
let _e18737 = (((_e18725 * _e613) + (_e18726 * _e626)) + (_e18727 * _e639));
let _e18742 = (((_e18722 * _e613) + (_e18723 * _e626)) + (_e18724 * _e639));
let _e18745 = ((_e18723 * _e639) - (_e18724 * _e626));
let _e18748 = ((_e18724 * _e613) - (_e18722 * _e639));
let _e18751 = ((_e18722 * _e626) - (_e18723 * _e613));
let _e18756 = (((_e18745 * _e18745) + (_e18748 * _e18748)) + (_e18751 * _e18751));
let _e18759 = (1f / select(1e-9f, _e18756, (_e18756 > 1e-9f)));
let _e18762 = ((_e18732 - (_e18742 * _e18737)) * _e18759);
let _e18765 = (((_e18742 * _e18732) - _e18737) * _e18759);
let _e18771 = select(0f, _e18762, (((_e18765 >= 0f) && (_e18765 < _e691)) && (_e18762 > 0f)));
let _e18773 = (_e18637 << bitcast<u32>(_e18263));
if _e18485 {
phi_52705_ = (_e18279.member - 1i);
} else {
phi_52705_ = _e18484;
}
let _e18788 = phi_52705_;
if _e18640 {
phi_52716_ = (_e18279.member_1 - 1i);
} else {
phi_52716_ = _e18639;
}
let _e18791 = phi_52716_;
let _e18795 = (((f32(_e18788) + 0.5f) * _e18284) - 0.5f);
let _e18799 = (((f32(_e18791) + 0.5f) * _e18284) - 0.5f);
if _e453 {
phi_52744_ = type_23(_e18791, _e18788);
} else {
phi_52744_ = type_23(_e18788, _e18791);
}
let _e18805 = phi_52744_;
if _e18355 {
phi_52795_ = 0u;
} else {
if (_e14814 == 1u) {
phi_52794_ = 0u;
} else {
if (_e14814 == 2u) {
phi_52793_ = _e17676;
} else {
phi_52793_ = select(_e17682, _e17679, (_e14814 == 3u));
}
let _e18813 = phi_52793_;
phi_52794_ = _e18813;
}
let _e18815 = phi_52794_;
phi_52795_ = _e18815;
}
let _e18817 = phi_52795_;
local_50 = (((bitcast<i32>(_e18817) + _e18805.member_1) * _e17673) + _e18805.member);
let _e18822 = local_50;
let _e18824 = select(_e17699, _e18822, (_e18822 < _e17699));
let _e18829 = global_6.member[bitcast<u32>(select(0i, _e18824, (_e18824 > 0i)))];
let _e18834 = (((((select(_e18795, _e18799, _e453) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e18839 = ((1f - (((select(_e18799, _e18795, _e453) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e18846 = ((_e17223.member * _e18834) + (_e17231.member * _e18839));
let _e18847 = ((_e17223.member_1 * _e18834) + (_e17231.member_1 * _e18839));
let _e18848 = ((_e17223.member_2 * _e18834) + (_e17231.member_2 * _e18839));
let _e18852 = select((_e17246.member + _e18846), _e17246.member, _e17244);
let _e18853 = select((_e17246.member_1 + _e18847), _e17246.member_1, _e17244);
let _e18854 = select((_e17246.member_2 + _e18848), _e17246.member_2, _e17244);
let _e18865 = (((_e18852 * _e18852) + (_e18853 * _e18853)) + (_e18854 * _e18854));
let _e18869 = (1f / sqrt(select(0f, _e18865, (_e18865 > 0f))));
let _e18870 = (_e18852 * _e18869);
let _e18871 = (_e18853 * _e18869);
let _e18872 = (_e18854 * _e18869);
let _e18873 = (_e575 - select(_e17257.member, (_e17257.member + _e18846), _e17244));
let _e18874 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e18847), _e17244));
let _e18875 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e18848), _e17244));
let _e18880 = (((_e18873 * _e18870) + (_e18874 * _e18871)) + (_e18875 * _e18872));
let _e18885 = (((_e18873 * _e613) + (_e18874 * _e626)) + (_e18875 * _e639));
let _e18890 = (((_e18870 * _e613) + (_e18871 * _e626)) + (_e18872 * _e639));
let _e18893 = ((_e18871 * _e639) - (_e18872 * _e626));
let _e18896 = ((_e18872 * _e613) - (_e18870 * _e639));
let _e18899 = ((_e18870 * _e626) - (_e18871 * _e613));
let _e18904 = (((_e18893 * _e18893) + (_e18896 * _e18896)) + (_e18899 * _e18899));
let _e18907 = (1f / select(1e-9f, _e18904, (_e18904 > 1e-9f)));
let _e18910 = ((_e18880 - (_e18890 * _e18885)) * _e18907);
let _e18913 = (((_e18890 * _e18880) - _e18885) * _e18907);
let _e18919 = select(0f, _e18910, (((_e18913 >= 0f) && (_e18913 < _e691)) && (_e18910 > 0f)));
let _e18921 = (_e18788 << bitcast<u32>(_e18263));
let _e18933 = select(((((_e18262 - select(0f, (_e18324 * _e18325), (((select(select(_e766, _e923, (_e18469 >= _e692)), _e845, (_e18469 < _e298)) == _e14814) && (_e18467 > 0f)) && (_e18467 < _e18377)))) - select(0f, (_e18321 * _e18325), (((select(select(_e766, _e923, (_e18621 >= _e692)), _e845, (_e18621 < _e298)) == _e14814) && (_e18619 > 0f)) && (_e18619 < _e18529)))) - select(0f, (_e18324 * _e18323), (((select(select(_e766, _e923, (_e18773 >= _e692)), _e845, (_e18773 < _e298)) == _e14814) && (_e18771 > 0f)) && (_e18771 < _e18681)))) - select(0f, (_e18321 * _e18323), (((select(select(_e766, _e923, (_e18921 >= _e692)), _e845, (_e18921 < _e298)) == _e14814) && (_e18919 > 0f)) && (_e18919 < _e18829)))), _e18262, _e18355);
let _e18934 = (_e14818 & 31u);
let _e18936 = (1u << bitcast<u32>(_e18934));
let _e18945 = bitcast<i32>((((_e14757 + _e18936) - 1u) >> bitcast<u32>(_e18934)));
let _e18946 = bitcast<i32>((((_e14760 + _e18936) - 1u) >> bitcast<u32>(_e18934)));
if _e453 {
phi_53474_ = type_23(_e18946, _e18945);
} else {
phi_53474_ = type_23(_e18945, _e18946);
}
let _e18950 = phi_53474_;
let _e18955 = f32((1i << bitcast<u32>(_e18934)));
let _e18956 = (1f / _e18955);
let _e18958 = ((_e17031 * _e18956) - 0.5f);
let _e18960 = ((_e17124 * _e18956) - 0.5f);
let _e18962 = select(-1f, _e18958, (_e18958 > -1f));
let _e18964 = select(1e6f, _e18962, (_e18962 < 1e6f));
let _e18971 = select(0i, select(select(i32(_e18964), i32(-2147483648), (_e18964 < -2147483600f)), 2147483647i, (_e18964 > 2147483500f)), (_e18964 == _e18964));
let _e18975 = (_e18971 - select(0i, 1i, (_e18964 < f32(_e18971))));
let _e18977 = select(-1f, _e18960, (_e18960 > -1f));
let _e18979 = select(1e6f, _e18977, (_e18977 < 1e6f));
let _e18986 = select(0i, select(select(i32(_e18979), i32(-2147483648), (_e18979 < -2147483600f)), 2147483647i, (_e18979 > 2147483500f)), (_e18979 == _e18979));
let _e18990 = (_e18986 - select(0i, 1i, (_e18979 < f32(_e18986))));
let _e18992 = (_e18958 - f32(_e18975));
let _e18994 = (_e18960 - f32(_e18990));
let _e18995 = (1f - _e18992);
let _e18996 = (1f - _e18994);
let _e18999 = select(_e18975, 0i, (_e18975 < 0i));
let _e19000 = (_e18999 >= _e18950.member);
if _e19000 {
phi_53552_ = (_e18950.member - 1i);
} else {
phi_53552_ = _e18999;
}
let _e19003 = phi_53552_;
let _e19005 = select(_e18990, 0i, (_e18990 < 0i));
let _e19006 = (_e19005 >= _e18950.member_1);
if _e19006 {
phi_53563_ = (_e18950.member_1 - 1i);
} else {
phi_53563_ = _e19005;
}
let _e19009 = phi_53563_;
let _e19013 = (((f32(_e19003) + 0.5f) * _e18955) - 0.5f);
let _e19017 = (((f32(_e19009) + 0.5f) * _e18955) - 0.5f);
if _e453 {
phi_53591_ = type_23(_e19009, _e19003);
} else {
phi_53591_ = type_23(_e19003, _e19009);
}
let _e19023 = phi_53591_;
let _e19026 = (_e14818 == 0u);
if _e19026 {
phi_53642_ = 0u;
} else {
if (_e14818 == 1u) {
phi_53641_ = 0u;
} else {
if (_e14818 == 2u) {
phi_53640_ = _e17676;
} else {
phi_53640_ = select(_e17682, _e17679, (_e14818 == 3u));
}
let _e19032 = phi_53640_;
phi_53641_ = _e19032;
}
let _e19034 = phi_53641_;
phi_53642_ = _e19034;
}
let _e19036 = phi_53642_;
local_48 = (((bitcast<i32>(_e19036) + _e19023.member_1) * _e17673) + _e19023.member);
let _e19041 = local_48;
let _e19043 = select(_e17699, _e19041, (_e19041 < _e17699));
let _e19048 = global_6.member[bitcast<u32>(select(0i, _e19043, (_e19043 > 0i)))];
let _e19053 = (((((select(_e19013, _e19017, _e453) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e19058 = ((1f - (((select(_e19017, _e19013, _e453) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e19065 = ((_e17223.member * _e19053) + (_e17231.member * _e19058));
let _e19066 = ((_e17223.member_1 * _e19053) + (_e17231.member_1 * _e19058));
let _e19067 = ((_e17223.member_2 * _e19053) + (_e17231.member_2 * _e19058));
let _e19071 = select((_e17246.member + _e19065), _e17246.member, _e17244);
let _e19072 = select((_e17246.member_1 + _e19066), _e17246.member_1, _e17244);
let _e19073 = select((_e17246.member_2 + _e19067), _e17246.member_2, _e17244);
let _e19084 = (((_e19071 * _e19071) + (_e19072 * _e19072)) + (_e19073 * _e19073));
let _e19088 = (1f / sqrt(select(0f, _e19084, (_e19084 > 0f))));
let _e19089 = (_e19071 * _e19088);
let _e19090 = (_e19072 * _e19088);
let _e19091 = (_e19073 * _e19088);
let _e19092 = (_e575 - select(_e17257.member, (_e17257.member + _e19065), _e17244));
let _e19093 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e19066), _e17244));
let _e19094 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e19067), _e17244));
let _e19099 = (((_e19092 * _e19089) + (_e19093 * _e19090)) + (_e19094 * _e19091));
let _e19104 = (((_e19092 * _e613) + (_e19093 * _e626)) + (_e19094 * _e639));
let _e19109 = (((_e19089 * _e613) + (_e19090 * _e626)) + (_e19091 * _e639));
let _e19112 = ((_e19090 * _e639) - (_e19091 * _e626));
let _e19115 = ((_e19091 * _e613) - (_e19089 * _e639));
let _e19118 = ((_e19089 * _e626) - (_e19090 * _e613));
let _e19123 = (((_e19112 * _e19112) + (_e19115 * _e19115)) + (_e19118 * _e19118));
let _e19126 = (1f / select(1e-9f, _e19123, (_e19123 > 1e-9f)));
let _e19129 = ((_e19099 - (_e19109 * _e19104)) * _e19126);
let _e19132 = (((_e19109 * _e19099) - _e19104) * _e19126);
let _e19138 = select(0f, _e19129, (((_e19132 >= 0f) && (_e19132 < _e691)) && (_e19129 > 0f)));
let _e19140 = (_e19003 << bitcast<u32>(_e18934));
let _e19152 = (_e18975 + 1i);
let _e19155 = select(_e19152, 0i, (_e19152 < 0i));
let _e19156 = (_e19155 >= _e18950.member);
if _e19156 {
phi_54303_ = (_e18950.member - 1i);
} else {
phi_54303_ = _e19155;
}
let _e19159 = phi_54303_;
if _e19006 {
phi_54314_ = (_e18950.member_1 - 1i);
} else {
phi_54314_ = _e19005;
}
let _e19162 = phi_54314_;
let _e19166 = (((f32(_e19159) + 0.5f) * _e18955) - 0.5f);
let _e19170 = (((f32(_e19162) + 0.5f) * _e18955) - 0.5f);
if _e453 {
phi_54342_ = type_23(_e19162, _e19159);
} else {
phi_54342_ = type_23(_e19159, _e19162);
}
let _e19176 = phi_54342_;
if _e19026 {
phi_54393_ = 0u;
} else {
if (_e14818 == 1u) {
phi_54392_ = 0u;
} else {
if (_e14818 == 2u) {
phi_54391_ = _e17676;
} else {
phi_54391_ = select(_e17682, _e17679, (_e14818 == 3u));
}
let _e19184 = phi_54391_;
phi_54392_ = _e19184;
}
let _e19186 = phi_54392_;
phi_54393_ = _e19186;
}
let _e19188 = phi_54393_;
local_46 = (((bitcast<i32>(_e19188) + _e19176.member_1) * _e17673) + _e19176.member);
let _e19193 = local_46;
let _e19195 = select(_e17699, _e19193, (_e19193 < _e17699));
let _e19200 = global_6.member[bitcast<u32>(select(0i, _e19195, (_e19195 > 0i)))];
let _e19205 = (((((select(_e19166, _e19170, _e453) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e19210 = ((1f - (((select(_e19170, _e19166, _e453) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e19217 = ((_e17223.member * _e19205) + (_e17231.member * _e19210));
let _e19218 = ((_e17223.member_1 * _e19205) + (_e17231.member_1 * _e19210));
let _e19219 = ((_e17223.member_2 * _e19205) + (_e17231.member_2 * _e19210));
let _e19223 = select((_e17246.member + _e19217), _e17246.member, _e17244);
let _e19224 = select((_e17246.member_1 + _e19218), _e17246.member_1, _e17244);
let _e19225 = select((_e17246.member_2 + _e19219), _e17246.member_2, _e17244);
let _e19236 = (((_e19223 * _e19223) + (_e19224 * _e19224)) + (_e19225 * _e19225));
let _e19240 = (1f / sqrt(select(0f, _e19236, (_e19236 > 0f))));
let _e19241 = (_e19223 * _e19240);
let _e19242 = (_e19224 * _e19240);
let _e19243 = (_e19225 * _e19240);
let _e19244 = (_e575 - select(_e17257.member, (_e17257.member + _e19217), _e17244));
let _e19245 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e19218), _e17244));
let _e19246 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e19219), _e17244));
let _e19251 = (((_e19244 * _e19241) + (_e19245 * _e19242)) + (_e19246 * _e19243));
let _e19256 = (((_e19244 * _e613) + (_e19245 * _e626)) + (_e19246 * _e639));
let _e19261 = (((_e19241 * _e613) + (_e19242 * _e626)) + (_e19243 * _e639));
let _e19264 = ((_e19242 * _e639) - (_e19243 * _e626));
let _e19267 = ((_e19243 * _e613) - (_e19241 * _e639));
let _e19270 = ((_e19241 * _e626) - (_e19242 * _e613));
let _e19275 = (((_e19264 * _e19264) + (_e19267 * _e19267)) + (_e19270 * _e19270));
let _e19278 = (1f / select(1e-9f, _e19275, (_e19275 > 1e-9f)));
let _e19281 = ((_e19251 - (_e19261 * _e19256)) * _e19278);
let _e19284 = (((_e19261 * _e19251) - _e19256) * _e19278);
let _e19290 = select(0f, _e19281, (((_e19284 >= 0f) && (_e19284 < _e691)) && (_e19281 > 0f)));
let _e19292 = (_e19159 << bitcast<u32>(_e18934));
let _e19304 = (_e18990 + 1i);
if _e19000 {
phi_55054_ = (_e18950.member - 1i);
} else {
phi_55054_ = _e18999;
}
let _e19308 = phi_55054_;
let _e19310 = select(_e19304, 0i, (_e19304 < 0i));
let _e19311 = (_e19310 >= _e18950.member_1);
if _e19311 {
phi_55065_ = (_e18950.member_1 - 1i);
} else {
phi_55065_ = _e19310;
}
let _e19314 = phi_55065_;
let _e19318 = (((f32(_e19308) + 0.5f) * _e18955) - 0.5f);
let _e19322 = (((f32(_e19314) + 0.5f) * _e18955) - 0.5f);
if _e453 {
phi_55093_ = type_23(_e19314, _e19308);
} else {
phi_55093_ = type_23(_e19308, _e19314);
}
let _e19328 = phi_55093_;
if _e19026 {
phi_55144_ = 0u;
} else {
if (_e14818 == 1u) {
phi_55143_ = 0u;
} else {
if (_e14818 == 2u) {
phi_55142_ = _e17676;
} else {
phi_55142_ = select(_e17682, _e17679, (_e14818 == 3u));
}
let _e19336 = phi_55142_;
phi_55143_ = _e19336;
}
let _e19338 = phi_55143_;
phi_55144_ = _e19338;
}
let _e19340 = phi_55144_;
local_44 = (((bitcast<i32>(_e19340) + _e19328.member_1) * _e17673) + _e19328.member);
let _e19345 = local_44;
let _e19347 = select(_e17699, _e19345, (_e19345 < _e17699));
let _e19352 = global_6.member[bitcast<u32>(select(0i, _e19347, (_e19347 > 0i)))];
let _e19357 = (((((select(_e19318, _e19322, _e453) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e19362 = ((1f - (((select(_e19322, _e19318, _e453) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e19369 = ((_e17223.member * _e19357) + (_e17231.member * _e19362));
let _e19370 = ((_e17223.member_1 * _e19357) + (_e17231.member_1 * _e19362));
let _e19371 = ((_e17223.member_2 * _e19357) + (_e17231.member_2 * _e19362));
let _e19375 = select((_e17246.member + _e19369), _e17246.member, _e17244);
let _e19376 = select((_e17246.member_1 + _e19370), _e17246.member_1, _e17244);
let _e19377 = select((_e17246.member_2 + _e19371), _e17246.member_2, _e17244);
let _e19388 = (((_e19375 * _e19375) + (_e19376 * _e19376)) + (_e19377 * _e19377));
let _e19392 = (1f / sqrt(select(0f, _e19388, (_e19388 > 0f))));
let _e19393 = (_e19375 * _e19392);
let _e19394 = (_e19376 * _e19392);
let _e19395 = (_e19377 * _e19392);
let _e19396 = (_e575 - select(_e17257.member, (_e17257.member + _e19369), _e17244));
let _e19397 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e19370), _e17244));
let _e19398 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e19371), _e17244));
let _e19403 = (((_e19396 * _e19393) + (_e19397 * _e19394)) + (_e19398 * _e19395));
let _e19408 = (((_e19396 * _e613) + (_e19397 * _e626)) + (_e19398 * _e639));
let _e19413 = (((_e19393 * _e613) + (_e19394 * _e626)) + (_e19395 * _e639));
let _e19416 = ((_e19394 * _e639) - (_e19395 * _e626));
let _e19419 = ((_e19395 * _e613) - (_e19393 * _e639));
let _e19422 = ((_e19393 * _e626) - (_e19394 * _e613));
let _e19427 = (((_e19416 * _e19416) + (_e19419 * _e19419)) + (_e19422 * _e19422));
let _e19430 = (1f / select(1e-9f, _e19427, (_e19427 > 1e-9f)));
let _e19433 = ((_e19403 - (_e19413 * _e19408)) * _e19430);
let _e19436 = (((_e19413 * _e19403) - _e19408) * _e19430);
let _e19442 = select(0f, _e19433, (((_e19436 >= 0f) && (_e19436 < _e691)) && (_e19433 > 0f)));
let _e19444 = (_e19308 << bitcast<u32>(_e18934));
if _e19156 {
phi_55805_ = (_e18950.member - 1i);
} else {
phi_55805_ = _e19155;
}
let _e19459 = phi_55805_;
if _e19311 {
phi_55816_ = (_e18950.member_1 - 1i);
} else {
phi_55816_ = _e19310;
}
let _e19462 = phi_55816_;
let _e19466 = (((f32(_e19459) + 0.5f) * _e18955) - 0.5f);
let _e19470 = (((f32(_e19462) + 0.5f) * _e18955) - 0.5f);
if _e453 {
phi_55844_ = type_23(_e19462, _e19459);
} else {
phi_55844_ = type_23(_e19459, _e19462);
}
let _e19476 = phi_55844_;
if _e19026 {
phi_55895_ = 0u;
} else {
if (_e14818 == 1u) {
phi_55894_ = 0u;
} else {
if (_e14818 == 2u) {
phi_55893_ = _e17676;
} else {
phi_55893_ = select(_e17682, _e17679, (_e14818 == 3u));
}
let _e19484 = phi_55893_;
phi_55894_ = _e19484;
}
let _e19486 = phi_55894_;
phi_55895_ = _e19486;
}
let _e19488 = phi_55895_;
local_42 = (((bitcast<i32>(_e19488) + _e19476.member_1) * _e17673) + _e19476.member);
let _e19493 = local_42;
let _e19495 = select(_e17699, _e19493, (_e19493 < _e17699));
let _e19500 = global_6.member[bitcast<u32>(select(0i, _e19495, (_e19495 > 0i)))];
let _e19505 = (((((select(_e19466, _e19470, _e453) + 0.5f) / _e17204) * 2f) - 1f) * _e17212);
let _e19510 = ((1f - (((select(_e19470, _e19466, _e453) + 0.5f) / _e17205) * 2f)) * _e17220);
let _e19517 = ((_e17223.member * _e19505) + (_e17231.member * _e19510));
let _e19518 = ((_e17223.member_1 * _e19505) + (_e17231.member_1 * _e19510));
let _e19519 = ((_e17223.member_2 * _e19505) + (_e17231.member_2 * _e19510));
let _e19523 = select((_e17246.member + _e19517), _e17246.member, _e17244);
let _e19524 = select((_e17246.member_1 + _e19518), _e17246.member_1, _e17244);
let _e19525 = select((_e17246.member_2 + _e19519), _e17246.member_2, _e17244);
let _e19536 = (((_e19523 * _e19523) + (_e19524 * _e19524)) + (_e19525 * _e19525));
let _e19540 = (1f / sqrt(select(0f, _e19536, (_e19536 > 0f))));
let _e19541 = (_e19523 * _e19540);
let _e19542 = (_e19524 * _e19540);
let _e19543 = (_e19525 * _e19540);
let _e19544 = (_e575 - select(_e17257.member, (_e17257.member + _e19517), _e17244));
let _e19545 = (_e587 - select(_e17257.member_1, (_e17257.member_1 + _e19518), _e17244));
let _e19546 = (_e600 - select(_e17257.member_2, (_e17257.member_2 + _e19519), _e17244));
let _e19551 = (((_e19544 * _e19541) + (_e19545 * _e19542)) + (_e19546 * _e19543));
let _e19556 = (((_e19544 * _e613) + (_e19545 * _e626)) + (_e19546 * _e639));
let _e19561 = (((_e19541 * _e613) + (_e19542 * _e626)) + (_e19543 * _e639));
let _e19564 = ((_e19542 * _e639) - (_e19543 * _e626));
let _e19567 = ((_e19543 * _e613) - (_e19541 * _e639));
let _e19570 = ((_e19541 * _e626) - (_e19542 * _e613));
let _e19575 = (((_e19564 * _e19564) + (_e19567 * _e19567)) + (_e19570 * _e19570));
let _e19578 = (1f / select(1e-9f, _e19575, (_e19575 > 1e-9f)));
let _e19581 = ((_e19551 - (_e19561 * _e19556)) * _e19578);
let _e19584 = (((_e19561 * _e19551) - _e19556) * _e19578);
let _e19590 = select(0f, _e19581, (((_e19584 >= 0f) && (_e19584 < _e691)) && (_e19581 > 0f)));
let _e19592 = (_e19459 << bitcast<u32>(_e18934));
let _e19604 = select(((((_e18933 - select(0f, (_e18995 * _e18996), (((select(select(_e766, _e923, (_e19140 >= _e692)), _e845, (_e19140 < _e298)) == _e14818) && (_e19138 > 0f)) && (_e19138 < _e19048)))) - select(0f, (_e18992 * _e18996), (((select(select(_e766, _e923, (_e19292 >= _e692)), _e845, (_e19292 < _e298)) == _e14818) && (_e19290 > 0f)) && (_e19290 < _e19200)))) - select(0f, (_e18995 * _e18994), (((select(select(_e766, _e923, (_e19444 >= _e692)), _e845, (_e19444 < _e298)) == _e14818) && (_e19442 > 0f)) && (_e19442 < _e19352)))) - select(0f, (_e18992 * _e18994), (((select(select(_e766, _e923, (_e19592 >= _e692)), _e845, (_e19592 < _e298)) == _e14818) && (_e19590 > 0f)) && (_e19590 < _e19500)))), _e18933, _e19026);
if _e453 {
phi_56565_ = type_23(_e17121, _e17029);
} else {
phi_56565_ = type_23(_e17029, _e17121);
}
let _e19619 = phi_56565_;
let _e19622 = (_e17122 && (((_e17577 > 0f) && (_e17577 < _e17201)) && (bitcast<f32>((bitcast<u32>(_e19604) & 2147483647u)) > 1e-6f)));
let _e19625 = global_1.member.member_18.member;
let _e19626 = (((select(_e17147, (1f - _e17147), (_e17132 >= 0f)) - select(_e17166, (1f - _e17166), (_e17151 >= 0f))) * (1f / _e17129)) * _e19625);
let _e19630 = select(0f, (((((_e652 * _e17414.member) * ((1f + (_e17454 * (1f + (_e17454 * (0.5f + (_e17454 * (0.16666667f + (_e17454 * (0.041666668f + (_e17454 * (0.008333334f + (_e17454 * (0.001388889f + (_e17454 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e17449 + 127i)) << bitcast<u32>(23i))))) * _e17407) * _e19604) * _e19626), _e19622);
let _e19631 = select(0f, (((((_e665 * _e17414.member_1) * ((1f + (_e17502 * (1f + (_e17502 * (0.5f + (_e17502 * (0.16666667f + (_e17502 * (0.041666668f + (_e17502 * (0.008333334f + (_e17502 * (0.001388889f + (_e17502 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e17497 + 127i)) << bitcast<u32>(23i))))) * _e17407) * _e19604) * _e19626), _e19622);
let _e19632 = select(0f, (((((_e678 * _e17414.member_2) * ((1f + (_e17550 * (1f + (_e17550 * (0.5f + (_e17550 * (0.16666667f + (_e17550 * (0.041666668f + (_e17550 * (0.008333334f + (_e17550 * (0.001388889f + (_e17550 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e17545 + 127i)) << bitcast<u32>(23i))))) * _e17407) * _e19604) * _e19626), _e19622);
let _e19636 = (bitcast<f32>((bitcast<u32>(_e19630) & 2147483647u)) >= 1073741800f);
let _e19637 = (1f / 1048576f);
let _e19640 = ((_e19630 * select(1f, _e19637, _e19636)) + 0.5f);
let _e19642 = select(-1073741800f, _e19640, (_e19640 > -1073741800f));
let _e19644 = select(1073741800f, _e19642, (_e19642 < 1073741800f));
let _e19651 = select(0i, select(select(i32(_e19644), i32(-2147483648), (_e19644 < -2147483600f)), 2147483647i, (_e19644 > 2147483500f)), (_e19644 == _e19644));
let _e19655 = (_e19651 - select(0i, 1i, (_e19644 < f32(_e19651))));
let _e19656 = select(0i, 20i, _e19636);
let _e19660 = (bitcast<u32>(_e19655) << bitcast<u32>((_e19656 & 31i)));
let _e19667 = bitcast<u32>(((_e19655 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19656) & 31i))));
let _e19671 = (bitcast<f32>((bitcast<u32>(_e19631) & 2147483647u)) >= 1073741800f);
let _e19674 = ((_e19631 * select(1f, _e19637, _e19671)) + 0.5f);
let _e19676 = select(-1073741800f, _e19674, (_e19674 > -1073741800f));
let _e19678 = select(1073741800f, _e19676, (_e19676 < 1073741800f));
let _e19685 = select(0i, select(select(i32(_e19678), i32(-2147483648), (_e19678 < -2147483600f)), 2147483647i, (_e19678 > 2147483500f)), (_e19678 == _e19678));
let _e19689 = (_e19685 - select(0i, 1i, (_e19678 < f32(_e19685))));
let _e19690 = select(0i, 20i, _e19671);
let _e19694 = (bitcast<u32>(_e19689) << bitcast<u32>((_e19690 & 31i)));
let _e19701 = bitcast<u32>(((_e19689 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19690) & 31i))));
let _e19705 = (bitcast<f32>((bitcast<u32>(_e19632) & 2147483647u)) >= 1073741800f);
let _e19708 = ((_e19632 * select(1f, _e19637, _e19705)) + 0.5f);
let _e19710 = select(-1073741800f, _e19708, (_e19708 > -1073741800f));
let _e19712 = select(1073741800f, _e19710, (_e19710 < 1073741800f));
let _e19719 = select(0i, select(select(i32(_e19712), i32(-2147483648), (_e19712 < -2147483600f)), 2147483647i, (_e19712 > 2147483500f)), (_e19712 == _e19712));
let _e19723 = (_e19719 - select(0i, 1i, (_e19712 < f32(_e19719))));
let _e19724 = select(0i, 20i, _e19705);
let _e19728 = (bitcast<u32>(_e19723) << bitcast<u32>((_e19724 & 31i)));
let _e19735 = bitcast<u32>(((_e19723 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19724) & 31i))));
let _e19740 = bitcast<i32>(bitcast<u32>((((_e19619.member_1 * _e14761) + _e19619.member) * 6i)));
if ((_e19660 | _e19667) == 0u) {
} else {
let _e19743 = bitcast<u32>(_e19740);
if (_e19743 < _e270) {
let _e19747 = atomicAdd((&global_8.member[_e19743]), _e19660);
phi_56798_ = _e19747;
} else {
phi_56798_ = 0u;
}
let _e19749 = phi_56798_;
let _e19753 = (_e19667 + select(0u, 1u, ((_e19749 + _e19660) < _e19660)));
if (_e19753 == 0u) {
} else {
let _e19755 = (_e19743 + 1u);
if (_e19755 < _e270) {
let _e19759 = atomicAdd((&global_8.member[_e19755]), _e19753);
}
}
}
if ((_e19694 | _e19701) == 0u) {
} else {
let _e19763 = bitcast<u32>((_e19740 + 2i));
if (_e19763 < _e270) {
let _e19767 = atomicAdd((&global_8.member[_e19763]), _e19694);
phi_56828_ = _e19767;
} else {
phi_56828_ = 0u;
}
let _e19769 = phi_56828_;
let _e19773 = (_e19701 + select(0u, 1u, ((_e19769 + _e19694) < _e19694)));
if (_e19773 == 0u) {
} else {
let _e19775 = (_e19763 + 1u);
if (_e19775 < _e270) {
let _e19779 = atomicAdd((&global_8.member[_e19775]), _e19773);
}
}
}
if ((_e19728 | _e19735) == 0u) {
} else {
let _e19783 = bitcast<u32>((_e19740 + 4i));
if (_e19783 < _e270) {
let _e19787 = atomicAdd((&global_8.member[_e19783]), _e19728);
phi_56858_ = _e19787;
} else {
phi_56858_ = 0u;
}
let _e19789 = phi_56858_;
let _e19793 = (_e19735 + select(0u, 1u, ((_e19789 + _e19728) < _e19728)));
if (_e19793 == 0u) {
} else {
let _e19795 = (_e19783 + 1u);
if (_e19795 < _e270) {
let _e19799 = atomicAdd((&global_8.member[_e19795]), _e19793);
}
}
}
phi_46474_ = (_e17119 + 1i);
} else {
phi_46474_ = i32();
}
let _e19802 = phi_46474_;
continue;
continuing {
phi_46473_ = _e19802;
break if !(_e17122);
}
}
phi_46320_ = (_e17026 + 1i);
} else {
phi_46320_ = i32();
}
let _e19806 = phi_46320_;
continue;
continuing {
phi_46319_ = _e19806;
break if !(_e17027);
}
}
}
}
} else {
let _e19808 = (_e766 & 31u);
let _e19810 = (1u << bitcast<u32>(_e19808));
let _e19819 = bitcast<i32>((((_e14757 + _e19810) - 1u) >> bitcast<u32>(_e19808)));
let _e19820 = bitcast<i32>((((_e14760 + _e19810) - 1u) >> bitcast<u32>(_e19808)));
if _e453 {
phi_56924_ = type_23(_e19820, _e19819);
} else {
phi_56924_ = type_23(_e19819, _e19820);
}
let _e19824 = phi_56924_;
let _e19828 = (_e14787 >> bitcast<u32>(_e19808));
if (_e19828 < _e19824.member) {
phi_56999_ = _e19828;
} else {
phi_56999_ = (_e19824.member - 1i);
}
let _e19834 = phi_56999_;
phi_57003_ = type_23(2147483647i, -1i);
phi_57006_ = 0i;
loop {
let _e19837 = phi_57003_;
let _e19839 = phi_57006_;
local_233 = _e19837;
local_234 = _e19837;
let _e19840 = (_e19839 < 16i);
if _e19840 {
let _e19842 = (1i << bitcast<u32>(_e19808));
let _e19843 = f32(_e19842);
let _e19845 = ((4u - _e766) & 31u);
let _e19850 = ((_e14805 >> bitcast<u32>(_e19808)) + (_e19839 & ((1i << bitcast<u32>(_e19845)) - 1i)));
let _e19854 = (((f32(_e19850) + 0.5f) * _e19843) - 0.5f);
let _e19858 = (-(((_e416 * _e19854) + _e442)) / _e429);
let _e19865 = bitcast<f32>((bitcast<u32>(((_e466 * _e19854) + ((_e479 * _e19858) + _e492))) & 2147483647u));
let _e19872 = bitcast<f32>((bitcast<u32>(((_e505 * _e19854) + ((_e518 * _e19858) + _e531))) & 2147483647u));
let _e19877 = (((0.5f * (_e19865 + _e19872)) / _e534) + (0.5f * _e19843));
let _e19878 = (1f / _e19843);
let _e19886 = ((((_e19858 + _e19877) + 0.5f) * _e19878) - 0.5f);
let _e19887 = f32((_e19824.member_1 - 1i));
let _e19888 = (0f - 1f);
let _e19890 = select(_e19888, _e19886, (_e19886 > _e19888));
let _e19892 = select(_e19887, _e19890, (_e19890 < _e19887));
let _e19899 = select(0i, select(select(i32(_e19892), i32(-2147483648), (_e19892 < -2147483600f)), 2147483647i, (_e19892 > 2147483500f)), (_e19892 == _e19892));
let _e19904 = (((((_e19858 - _e19877) + 0.5f) * _e19878) - 0.5f) + 1f);
let _e19905 = (_e19887 + 1f);
let _e19907 = select(0f, _e19904, (_e19904 > 0f));
let _e19909 = select(_e19905, _e19907, (_e19907 < _e19905));
let _e19916 = select(0i, select(select(i32(_e19909), i32(-2147483648), (_e19909 < -2147483600f)), 2147483647i, (_e19909 > 2147483500f)), (_e19909 == _e19909));
let _e19927 = ((1e-4f * _e19843) * _e534);
let _e19929 = select(_e19872, _e19865, (_e19865 > _e19872));
let _e19931 = select(_e19927, _e19929, (_e19929 > _e19927));
let _e19933 = select(_e19872, _e19865, (_e19865 < _e19872));
let _e19935 = select(_e19927, _e19933, (_e19933 > _e19927));
let _e19937 = (0.5f * (_e19931 + _e19935));
let _e19938 = (0.5f / _e19935);
let _e19939 = (1f / _e19931);
phi_57157_ = _e19837;
phi_57160_ = 0i;
loop {
let _e19941 = phi_57157_;
let _e19943 = phi_57160_;
local_242 = _e19941;
let _e19946 = (((_e19916 - select(0i, 1i, (_e19909 < f32(_e19916)))) + (_e19839 >> bitcast<u32>(_e19845))) + (_e19943 << bitcast<u32>(_e19808)));
let _e19947 = (_e19946 <= select(-1i, (_e19899 - select(0i, 1i, (_e19892 < f32(_e19899)))), (_e19850 <= _e19834)));
if _e19947 {
let _e19951 = (((f32(_e19946) + 0.5f) * _e19843) - 0.5f);
let _e19953 = ((_e19951 - _e19858) * _e534);
let _e19954 = (_e534 * _e19843);
let _e19956 = (0.5f * _e19954);
let _e19957 = (_e19953 + _e19956);
let _e19958 = -(_e19957);
let _e19961 = (_e19937 - select(_e19958, _e19957, (_e19957 > _e19958)));
let _e19963 = select(0f, _e19961, (_e19961 > 0f));
let _e19965 = select(_e19935, _e19963, (_e19963 < _e19935));
let _e19968 = (_e19961 - _e19935);
let _e19972 = (((_e19965 * (_e19965 * _e19938)) + select(0f, _e19968, (_e19968 > 0f))) * _e19939);
let _e19976 = (_e19953 - _e19956);
let _e19977 = -(_e19976);
let _e19980 = (_e19937 - select(_e19977, _e19976, (_e19976 > _e19977)));
let _e19982 = select(0f, _e19980, (_e19980 > 0f));
let _e19984 = select(_e19935, _e19982, (_e19982 < _e19935));
let _e19987 = (_e19980 - _e19935);
let _e19991 = (((_e19984 * (_e19984 * _e19938)) + select(0f, _e19987, (_e19987 > 0f))) * _e19939);
if _e453 {
phi_57290_ = type_23(_e19946, _e19850);
} else {
phi_57290_ = type_23(_e19850, _e19946);
}
let _e20002 = phi_57290_;
let _e20008 = bitcast<i32>(((_e14757 + 1u) >> bitcast<u32>(1u)));
let _e20011 = global_1.member.member_18.member_9;
let _e20016 = global_1.member.member_18.member_6;
let _e20019 = global_1.member.member_18.member_7;
let _e20022 = global_1.member.member_18.member_8;
if _e14812 {
phi_57341_ = 0u;
} else {
if (_e766 == 1u) {
phi_57340_ = 0u;
} else {
if (_e766 == 2u) {
phi_57339_ = _e20016;
} else {
phi_57339_ = select(_e20022, _e20019, (_e766 == 3u));
}
let _e20028 = phi_57339_;
phi_57340_ = _e20028;
}
let _e20030 = phi_57340_;
phi_57341_ = _e20030;
}
let _e20032 = phi_57341_;
local_40 = (((bitcast<i32>(_e20032) + _e20002.member_1) * _e20008) + _e20002.member);
local_41 = (_e20008 * bitcast<i32>(_e20011));
let _e20037 = local_40;
let _e20039 = (bitcast<i32>(_e262) - 1i);
let _e20041 = select(_e20039, _e20037, (_e20037 < _e20039));
let _e20046 = global_6.member[bitcast<u32>(select(0i, _e20041, (_e20041 > 0i)))];
let _e20047 = local_41;
let _e20048 = local_40;
let _e20049 = (_e20047 + _e20048);
let _e20051 = select(_e20039, _e20049, (_e20049 < _e20039));
let _e20056 = global_6.member[bitcast<u32>(select(0i, _e20051, (_e20051 > 0i)))];
let _e20057 = local_41;
let _e20059 = local_40;
let _e20060 = ((2i * _e20057) + _e20059);
let _e20062 = select(_e20039, _e20060, (_e20060 < _e20039));
let _e20067 = global_6.member[bitcast<u32>(select(0i, _e20062, (_e20062 > 0i)))];
let _e20069 = (_e19842 >> bitcast<u32>(1i));
let _e20072 = ((_e20002.member << bitcast<u32>(_e19808)) + _e20069);
let _e20075 = ((_e20002.member_1 << bitcast<u32>(_e19808)) + _e20069);
let _e20077 = select(_e20072, 0i, (_e20072 < 0i));
if (_e20077 >= _e14761) {
phi_57467_ = (_e14761 - 1i);
} else {
phi_57467_ = _e20077;
}
let _e20081 = phi_57467_;
let _e20083 = select(_e20075, 0i, (_e20075 < 0i));
if (_e20083 >= _e14762) {
phi_57478_ = (_e14762 - 1i);
} else {
phi_57478_ = _e20083;
}
let _e20087 = phi_57478_;
local_38 = bitcast<i32>((_e14757 * _e14760));
local_39 = ((_e20087 * _e14761) + _e20081);
let _e20092 = local_38;
let _e20093 = local_39;
let _e20094 = (_e20092 + _e20093);
let _e20096 = (bitcast<i32>(_e259) - 1i);
let _e20098 = select(_e20096, _e20094, (_e20094 < _e20096));
let _e20103 = global_5.member[bitcast<u32>(select(0i, _e20098, (_e20098 > 0i)))];
let _e20112 = global_1.member.member_2.member;
let _e20113 = (((((select(_e19854, _e19951, _e453) + 0.5f) / f32(_e14761)) * 2f) - 1f) * _e20112);
let _e20120 = global_1.member.member_2.member_1;
let _e20121 = ((1f - (((select(_e19951, _e19854, _e453) + 0.5f) / f32(_e14762)) * 2f)) * _e20120);
let _e20123 = global_1.member.member_3;
let _e20131 = global_1.member.member_4;
let _e20138 = ((_e20123.member * _e20113) + (_e20131.member * _e20121));
let _e20139 = ((_e20123.member_1 * _e20113) + (_e20131.member_1 * _e20121));
let _e20140 = ((_e20123.member_2 * _e20113) + (_e20131.member_2 * _e20121));
let _e20143 = global_1.member.member_2.member_3;
let _e20144 = (_e20143 != 0u);
let _e20146 = global_1.member.member_5;
let _e20153 = select((_e20146.member + _e20138), _e20146.member, _e20144);
let _e20154 = select((_e20146.member_1 + _e20139), _e20146.member_1, _e20144);
let _e20155 = select((_e20146.member_2 + _e20140), _e20146.member_2, _e20144);
let _e20157 = global_1.member.member_6;
let _e20171 = (((_e20153 * _e20153) + (_e20154 * _e20154)) + (_e20155 * _e20155));
let _e20174 = sqrt(select(0f, _e20171, (_e20171 > 0f)));
let _e20175 = (1f / _e20174);
let _e20176 = (_e20153 * _e20175);
let _e20177 = (_e20154 * _e20175);
let _e20178 = (_e20155 * _e20175);
let _e20179 = (_e575 - select(_e20157.member, (_e20157.member + _e20138), _e20144));
let _e20180 = (_e587 - select(_e20157.member_1, (_e20157.member_1 + _e20139), _e20144));
let _e20181 = (_e600 - select(_e20157.member_2, (_e20157.member_2 + _e20140), _e20144));
let _e20186 = (((_e20179 * _e20176) + (_e20180 * _e20177)) + (_e20181 * _e20178));
let _e20191 = (((_e20179 * _e613) + (_e20180 * _e626)) + (_e20181 * _e639));
let _e20196 = (((_e20176 * _e613) + (_e20177 * _e626)) + (_e20178 * _e639));
let _e20199 = ((_e20177 * _e639) - (_e20178 * _e626));
let _e20202 = ((_e20178 * _e613) - (_e20176 * _e639));
let _e20205 = ((_e20176 * _e626) - (_e20177 * _e613));
let _e20210 = (((_e20199 * _e20199) + (_e20202 * _e20202)) + (_e20205 * _e20205));
let _e20213 = (1f / select(1e-9f, _e20210, (_e20210 > 1e-9f)));
let _e20216 = ((_e20186 - (_e20196 * _e20191)) * _e20213);
let _e20219 = (((_e20196 * _e20186) - _e20191) * _e20213);
let _e20225 = -(_e20196);
let _e20228 = global_1.member.member_13.member_2;
let _e20229 = (_e20228 * _e20228);
let _e20233 = ((1f + _e20229) - ((2f * _e20228) * _e20225));
let _e20235 = select(1e-9f, _e20233, (_e20233 > 1e-9f));
let _e20247 = global_1.member.member_13.member_3;
if (_e20247 == 2u) {
let _e20252 = (0.5f - (0.5f * _e20225));
let _e20254 = select(0f, _e20252, (_e20252 > 0f));
let _e20258 = (sqrt(select(0f, _e20254, (_e20254 > 0f))) * 255f);
let _e20259 = (255f - 1f);
let _e20261 = select(0f, _e20258, (_e20258 > 0f));
let _e20263 = select(_e20259, _e20261, (_e20261 < _e20259));
let _e20270 = select(0i, select(select(i32(_e20263), i32(-2147483648), (_e20263 < -2147483600f)), 2147483647i, (_e20263 > 2147483500f)), (_e20263 == _e20263));
let _e20274 = (_e20270 - select(0i, 1i, (_e20263 < f32(_e20270))));
let _e20277 = global_1.member.member_13.member_11;
let _e20278 = bitcast<i32>(_e20277);
let _e20279 = (_e20278 + _e20274);
let _e20281 = (bitcast<i32>(_e265) - 1i);
let _e20283 = select(_e20281, _e20279, (_e20279 < _e20281));
let _e20288 = global_2.member[bitcast<u32>(select(0i, _e20283, (_e20283 > 0i)))];
let _e20290 = (_e20278 + (_e20274 + 1i));
let _e20292 = select(_e20281, _e20290, (_e20290 < _e20281));
let _e20297 = global_2.member[bitcast<u32>(select(0i, _e20292, (_e20292 > 0i)))];
phi_57901_ = (_e20288 + ((_e20297 - _e20288) * (_e20258 - f32(_e20274))));
} else {
phi_57901_ = select(((1f - _e20229) / (_e20235 * sqrt(select(0f, _e20235, (_e20235 > 0f))))), (0.75f * (1f + (_e20225 * _e20225))), (_e20247 == 1u));
}
let _e20304 = phi_57901_;
let _e20307 = (_e20174 * (_e20304 * (0.25f / 3.1415927f)));
let _e20308 = (_e20216 - _e20103);
let _e20311 = (_e20219 + select(0f, _e20308, (_e20308 > 0f)));
let _e20314 = global_1.member.member_13.member_1;
let _e20323 = global_1.member.member_13.member;
let _e20328 = -((_e20323.member * _e20311));
let _e20330 = select(-87f, _e20328, (_e20328 > -87f));
let _e20332 = select(88f, _e20330, (_e20330 < 88f));
let _e20334 = ((_e20332 * 1.442695f) + 0.5f);
let _e20336 = select(-127f, _e20334, (_e20334 > -127f));
let _e20338 = select(128f, _e20336, (_e20336 < 128f));
let _e20345 = select(0i, select(select(i32(_e20338), i32(-2147483648), (_e20338 < -2147483600f)), 2147483647i, (_e20338 > 2147483500f)), (_e20338 == _e20338));
let _e20349 = (_e20345 - select(0i, 1i, (_e20338 < f32(_e20345))));
let _e20350 = f32(_e20349);
let _e20354 = ((_e20332 - (_e20350 * 0.6933594f)) - (_e20350 * -2.1219444e-4f));
let _e20376 = -((_e20323.member_1 * _e20311));
let _e20378 = select(-87f, _e20376, (_e20376 > -87f));
let _e20380 = select(88f, _e20378, (_e20378 < 88f));
let _e20382 = ((_e20380 * 1.442695f) + 0.5f);
let _e20384 = select(-127f, _e20382, (_e20382 > -127f));
let _e20386 = select(128f, _e20384, (_e20384 < 128f));
let _e20393 = select(0i, select(select(i32(_e20386), i32(-2147483648), (_e20386 < -2147483600f)), 2147483647i, (_e20386 > 2147483500f)), (_e20386 == _e20386));
let _e20397 = (_e20393 - select(0i, 1i, (_e20386 < f32(_e20393))));
let _e20398 = f32(_e20397);
let _e20402 = ((_e20380 - (_e20398 * 0.6933594f)) - (_e20398 * -2.1219444e-4f));
let _e20424 = -((_e20323.member_2 * _e20311));
let _e20426 = select(-87f, _e20424, (_e20424 > -87f));
let _e20428 = select(88f, _e20426, (_e20426 < 88f));
let _e20430 = ((_e20428 * 1.442695f) + 0.5f);
let _e20432 = select(-127f, _e20430, (_e20430 > -127f));
let _e20434 = select(128f, _e20432, (_e20432 < 128f));
let _e20441 = select(0i, select(select(i32(_e20434), i32(-2147483648), (_e20434 < -2147483600f)), 2147483647i, (_e20434 > 2147483500f)), (_e20434 == _e20434));
let _e20445 = (_e20441 - select(0i, 1i, (_e20434 < f32(_e20441))));
let _e20446 = f32(_e20445);
let _e20450 = ((_e20428 - (_e20446 * 0.6933594f)) - (_e20446 * -2.1219444e-4f));
let _e20477 = select(0f, _e20216, (((_e20219 >= 0f) && (_e20219 < _e691)) && (_e20216 > 0f)));
let _e20480 = ((_e20477 > 0f) && (_e20477 < _e20046));
if _e453 {
phi_58167_ = type_23(_e19946, _e19850);
} else {
phi_58167_ = type_23(_e19850, _e19946);
}
let _e20504 = phi_58167_;
let _e20507 = (_e19947 && _e20480);
let _e20510 = global_1.member.member_18.member;
let _e20511 = (((select(_e19972, (1f - _e19972), (_e19957 >= 0f)) - select(_e19991, (1f - _e19991), (_e19976 >= 0f))) * (1f / _e19954)) * _e20510);
let _e20515 = select(0f, ((((_e652 * _e20314.member) * ((1f + (_e20354 * (1f + (_e20354 * (0.5f + (_e20354 * (0.16666667f + (_e20354 * (0.041666668f + (_e20354 * (0.008333334f + (_e20354 * (0.001388889f + (_e20354 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20349 + 127i)) << bitcast<u32>(23i))))) * _e20307) * _e20511), _e20507);
let _e20516 = select(0f, ((((_e665 * _e20314.member_1) * ((1f + (_e20402 * (1f + (_e20402 * (0.5f + (_e20402 * (0.16666667f + (_e20402 * (0.041666668f + (_e20402 * (0.008333334f + (_e20402 * (0.001388889f + (_e20402 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20397 + 127i)) << bitcast<u32>(23i))))) * _e20307) * _e20511), _e20507);
let _e20517 = select(0f, ((((_e678 * _e20314.member_2) * ((1f + (_e20450 * (1f + (_e20450 * (0.5f + (_e20450 * (0.16666667f + (_e20450 * (0.041666668f + (_e20450 * (0.008333334f + (_e20450 * (0.001388889f + (_e20450 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20445 + 127i)) << bitcast<u32>(23i))))) * _e20307) * _e20511), _e20507);
let _e20521 = (bitcast<f32>((bitcast<u32>(_e20515) & 2147483647u)) >= 1073741800f);
let _e20522 = (1f / 1048576f);
let _e20525 = ((_e20515 * select(1f, _e20522, _e20521)) + 0.5f);
let _e20527 = select(-1073741800f, _e20525, (_e20525 > -1073741800f));
let _e20529 = select(1073741800f, _e20527, (_e20527 < 1073741800f));
let _e20536 = select(0i, select(select(i32(_e20529), i32(-2147483648), (_e20529 < -2147483600f)), 2147483647i, (_e20529 > 2147483500f)), (_e20529 == _e20529));
let _e20540 = (_e20536 - select(0i, 1i, (_e20529 < f32(_e20536))));
let _e20541 = select(0i, 20i, _e20521);
let _e20545 = (bitcast<u32>(_e20540) << bitcast<u32>((_e20541 & 31i)));
let _e20552 = bitcast<u32>(((_e20540 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e20541) & 31i))));
let _e20556 = (bitcast<f32>((bitcast<u32>(_e20516) & 2147483647u)) >= 1073741800f);
let _e20559 = ((_e20516 * select(1f, _e20522, _e20556)) + 0.5f);
let _e20561 = select(-1073741800f, _e20559, (_e20559 > -1073741800f));
let _e20563 = select(1073741800f, _e20561, (_e20561 < 1073741800f));
let _e20570 = select(0i, select(select(i32(_e20563), i32(-2147483648), (_e20563 < -2147483600f)), 2147483647i, (_e20563 > 2147483500f)), (_e20563 == _e20563));
let _e20574 = (_e20570 - select(0i, 1i, (_e20563 < f32(_e20570))));
let _e20575 = select(0i, 20i, _e20556);
let _e20579 = (bitcast<u32>(_e20574) << bitcast<u32>((_e20575 & 31i)));
let _e20586 = bitcast<u32>(((_e20574 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e20575) & 31i))));
let _e20590 = (bitcast<f32>((bitcast<u32>(_e20517) & 2147483647u)) >= 1073741800f);
let _e20593 = ((_e20517 * select(1f, _e20522, _e20590)) + 0.5f);
let _e20595 = select(-1073741800f, _e20593, (_e20593 > -1073741800f));
let _e20597 = select(1073741800f, _e20595, (_e20595 < 1073741800f));
let _e20604 = select(0i, select(select(i32(_e20597), i32(-2147483648), (_e20597 < -2147483600f)), 2147483647i, (_e20597 > 2147483500f)), (_e20597 == _e20597));
let _e20608 = (_e20604 - select(0i, 1i, (_e20597 < f32(_e20604))));
let _e20609 = select(0i, 20i, _e20590);
let _e20613 = (bitcast<u32>(_e20608) << bitcast<u32>((_e20609 & 31i)));
let _e20620 = bitcast<u32>(((_e20608 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e20609) & 31i))));
let _e20625 = global_1.member.member_18.member_2;
let _e20628 = global_1.member.member_18.member_3;
let _e20631 = global_1.member.member_18.member_4;
let _e20634 = global_1.member.member_18.member_5;
if _e14812 {
phi_58366_ = 0u;
} else {
if (_e766 == 1u) {
phi_58365_ = _e20625;
} else {
if (_e766 == 2u) {
phi_58364_ = _e20628;
} else {
phi_58364_ = select(_e20634, _e20631, (_e766 == 3u));
}
let _e20640 = phi_58364_;
phi_58365_ = _e20640;
}
let _e20642 = phi_58365_;
phi_58366_ = _e20642;
}
let _e20644 = phi_58366_;
let _e20652 = bitcast<i32>(bitcast<u32>((((bitcast<i32>(_e20644) + (_e20504.member_1 * _e19819)) + _e20504.member) * 6i)));
if ((_e20545 | _e20552) == 0u) {
} else {
let _e20655 = bitcast<u32>(_e20652);
if (_e20655 < _e270) {
let _e20659 = atomicAdd((&global_8.member[_e20655]), _e20545);
phi_58400_ = _e20659;
} else {
phi_58400_ = 0u;
}
let _e20661 = phi_58400_;
let _e20665 = (_e20552 + select(0u, 1u, ((_e20661 + _e20545) < _e20545)));
if (_e20665 == 0u) {
} else {
let _e20667 = (_e20655 + 1u);
if (_e20667 < _e270) {
let _e20671 = atomicAdd((&global_8.member[_e20667]), _e20665);
}
}
}
if ((_e20579 | _e20586) == 0u) {
} else {
let _e20675 = bitcast<u32>((_e20652 + 2i));
if (_e20675 < _e270) {
let _e20679 = atomicAdd((&global_8.member[_e20675]), _e20579);
phi_58430_ = _e20679;
} else {
phi_58430_ = 0u;
}
let _e20681 = phi_58430_;
let _e20685 = (_e20586 + select(0u, 1u, ((_e20681 + _e20579) < _e20579)));
if (_e20685 == 0u) {
} else {
let _e20687 = (_e20675 + 1u);
if (_e20687 < _e270) {
let _e20691 = atomicAdd((&global_8.member[_e20687]), _e20685);
}
}
}
if ((_e20613 | _e20620) == 0u) {
} else {
let _e20695 = bitcast<u32>((_e20652 + 4i));
if (_e20695 < _e270) {
let _e20699 = atomicAdd((&global_8.member[_e20695]), _e20613);
phi_58460_ = _e20699;
} else {
phi_58460_ = 0u;
}
let _e20701 = phi_58460_;
let _e20705 = (_e20620 + select(0u, 1u, ((_e20701 + _e20613) < _e20613)));
if (_e20705 == 0u) {
} else {
let _e20707 = (_e20695 + 1u);
if (_e20707 < _e270) {
let _e20711 = atomicAdd((&global_8.member[_e20707]), _e20705);
}
}
}
let _e20712 = bitcast<i32>(bitcast<u32>(select(-1i, _e19946, (_e19947 && (!(((_e20480 && !(((((_e19850 * _e19842) == _e298) && (_e845 != _e766)) || ((((_e19850 + 1i) * _e19842) == _e692) && (_e923 != _e766))))) && ((_e20477 * (1f + (0.02f * _e19843))) < _e20067))) && (_e20477 <= _e20056))))));
if (_e20712 >= 0i) {
phi_58497_ = type_23(select(_e19941.member, _e20712, (_e20712 < _e19941.member)), select(_e19941.member_1, _e20712, (_e20712 > _e19941.member_1)));
} else {
phi_58497_ = _e19941;
}
let _e20722 = phi_58497_;
phi_57158_ = _e20722;
phi_57161_ = (_e19943 + 1i);
} else {
phi_57158_ = type_23();
phi_57161_ = i32();
}
let _e20725 = phi_57158_;
let _e20727 = phi_57161_;
continue;
continuing {
phi_57157_ = _e20725;
phi_57160_ = _e20727;
break if !(_e19947);
}
}
let _e26268 = local_242;
phi_57004_ = _e26268;
phi_57007_ = (_e19839 + 1i);
} else {
phi_57004_ = type_23();
phi_57007_ = i32();
}
let _e20731 = phi_57004_;
let _e20733 = phi_57007_;
continue;
continuing {
phi_57003_ = _e20731;
phi_57006_ = _e20733;
break if !(_e19840);
}
}
let _e20736 = local_233;
let _e20739 = local_234;
if (_e20736.member <= _e20739.member_1) {
let _e20744 = ((_e20739.member_1 + 1i) << bitcast<u32>(_e19808));
if (_e20744 <= _e14811) {
phi_58514_ = (_e20744 - 1i);
} else {
phi_58514_ = _e14811;
}
let _e20748 = phi_58514_;
let _e20750 = (_e20736.member << bitcast<u32>(_e19808));
let _e20752 = select(_e845, 0u, (_e845 == _e766));
let _e20756 = select(_e923, 0u, ((_e923 == _e766) || (_e923 == _e845)));
let _e20764 = ((select(0u, 1u, (_e766 > 0u)) + select(0u, 1u, (_e20752 > 0u))) + select(0u, 1u, (_e20756 > 0u)));
if (_e20764 == 0u) {
phi_58549_ = 0i;
loop {
let _e20767 = phi_58549_;
let _e20768 = (_e20767 < 16i);
if _e20768 {
let _e20770 = (_e14806 + (_e20767 & 15i));
let _e20774 = (((f32(_e20770) + 0.5f) * 1f) - 0.5f);
let _e20778 = (-(((_e416 * _e20774) + _e442)) / _e429);
let _e20785 = bitcast<f32>((bitcast<u32>(((_e466 * _e20774) + ((_e479 * _e20778) + _e492))) & 2147483647u));
let _e20792 = bitcast<f32>((bitcast<u32>(((_e505 * _e20774) + ((_e518 * _e20778) + _e531))) & 2147483647u));
let _e20796 = (((0.5f * (_e20785 + _e20792)) / _e534) + _e717);
let _e20797 = (1f / 1f);
let _e20805 = ((((_e20778 + _e20796) + 0.5f) * _e20797) - 0.5f);
let _e20806 = f32(_e20750);
let _e20807 = f32(_e20748);
let _e20808 = (_e20806 - 1f);
let _e20810 = select(_e20808, _e20805, (_e20805 > _e20808));
let _e20812 = select(_e20807, _e20810, (_e20810 < _e20807));
let _e20819 = select(0i, select(select(i32(_e20812), i32(-2147483648), (_e20812 < -2147483600f)), 2147483647i, (_e20812 > 2147483500f)), (_e20812 == _e20812));
let _e20824 = (((((_e20778 - _e20796) + 0.5f) * _e20797) - 0.5f) + 1f);
let _e20825 = (_e20807 + 1f);
let _e20827 = select(_e20806, _e20824, (_e20824 > _e20806));
let _e20829 = select(_e20825, _e20827, (_e20827 < _e20825));
let _e20836 = select(0i, select(select(i32(_e20829), i32(-2147483648), (_e20829 < -2147483600f)), 2147483647i, (_e20829 > 2147483500f)), (_e20829 == _e20829));
let _e20847 = ((1e-4f * 1f) * _e534);
let _e20849 = select(_e20792, _e20785, (_e20785 > _e20792));
let _e20851 = select(_e20847, _e20849, (_e20849 > _e20847));
let _e20853 = select(_e20792, _e20785, (_e20785 < _e20792));
let _e20855 = select(_e20847, _e20853, (_e20853 > _e20847));
let _e20857 = (0.5f * (_e20851 + _e20855));
let _e20858 = (0.5f / _e20855);
let _e20859 = (1f / _e20851);
phi_58703_ = 0i;
loop {
let _e20861 = phi_58703_;
let _e20863 = (((_e20836 - select(0i, 1i, (_e20829 < f32(_e20836)))) + (_e20767 >> bitcast<u32>(4u))) + bitcast<i32>(_e20861));
let _e20864 = (_e20863 <= select(-1i, (_e20819 - select(0i, 1i, (_e20812 < f32(_e20819)))), (_e20770 <= _e14810)));
if _e20864 {
let _e20870 = (((((f32(_e20863) + 0.5f) * 1f) - 0.5f) - _e20778) * _e534);
let _e20871 = (_e534 * 1f);
let _e20873 = (0.5f * _e20871);
let _e20874 = (_e20870 + _e20873);
let _e20875 = -(_e20874);
let _e20878 = (_e20857 - select(_e20875, _e20874, (_e20874 > _e20875)));
let _e20880 = select(0f, _e20878, (_e20878 > 0f));
let _e20882 = select(_e20855, _e20880, (_e20880 < _e20855));
let _e20885 = (_e20878 - _e20855);
let _e20889 = (((_e20882 * (_e20882 * _e20858)) + select(0f, _e20885, (_e20885 > 0f))) * _e20859);
let _e20893 = (_e20870 - _e20873);
let _e20894 = -(_e20893);
let _e20897 = (_e20857 - select(_e20894, _e20893, (_e20893 > _e20894)));
let _e20899 = select(0f, _e20897, (_e20897 > 0f));
let _e20901 = select(_e20855, _e20899, (_e20899 < _e20855));
let _e20904 = (_e20897 - _e20855);
let _e20908 = (((_e20901 * (_e20901 * _e20858)) + select(0f, _e20904, (_e20904 > 0f))) * _e20859);
if _e453 {
phi_58808_ = type_23(_e20863, _e20770);
} else {
phi_58808_ = type_23(_e20770, _e20863);
}
let _e20917 = phi_58808_;
local_36 = bitcast<i32>((_e14757 * _e14760));
local_37 = ((_e20917.member_1 * _e14761) + _e20917.member);
let _e20924 = local_36;
let _e20925 = local_37;
let _e20926 = (_e20924 + _e20925);
let _e20928 = (bitcast<i32>(_e259) - 1i);
let _e20930 = select(_e20928, _e20926, (_e20926 < _e20928));
let _e20935 = global_5.member[bitcast<u32>(select(0i, _e20930, (_e20930 > 0i)))];
let _e20936 = local_37;
let _e20938 = select(_e20928, _e20936, (_e20936 < _e20928));
let _e20943 = global_5.member[bitcast<u32>(select(0i, _e20938, (_e20938 > 0i)))];
let _e20954 = global_1.member.member_2.member;
let _e20955 = (((((f32(_e20917.member) + 0.5f) / f32(_e14761)) * 2f) - 1f) * _e20954);
let _e20962 = global_1.member.member_2.member_1;
let _e20963 = ((1f - (((f32(_e20917.member_1) + 0.5f) / f32(_e14762)) * 2f)) * _e20962);
let _e20965 = global_1.member.member_3;
let _e20973 = global_1.member.member_4;
let _e20980 = ((_e20965.member * _e20955) + (_e20973.member * _e20963));
let _e20981 = ((_e20965.member_1 * _e20955) + (_e20973.member_1 * _e20963));
let _e20982 = ((_e20965.member_2 * _e20955) + (_e20973.member_2 * _e20963));
let _e20985 = global_1.member.member_2.member_3;
let _e20986 = (_e20985 != 0u);
let _e20988 = global_1.member.member_5;
let _e20995 = select((_e20988.member + _e20980), _e20988.member, _e20986);
let _e20996 = select((_e20988.member_1 + _e20981), _e20988.member_1, _e20986);
let _e20997 = select((_e20988.member_2 + _e20982), _e20988.member_2, _e20986);
let _e20999 = global_1.member.member_6;
let _e21013 = (((_e20995 * _e20995) + (_e20996 * _e20996)) + (_e20997 * _e20997));
let _e21016 = sqrt(select(0f, _e21013, (_e21013 > 0f)));
let _e21017 = (1f / _e21016);
let _e21018 = (_e20995 * _e21017);
let _e21019 = (_e20996 * _e21017);
let _e21020 = (_e20997 * _e21017);
let _e21021 = (_e575 - select(_e20999.member, (_e20999.member + _e20980), _e20986));
let _e21022 = (_e587 - select(_e20999.member_1, (_e20999.member_1 + _e20981), _e20986));
let _e21023 = (_e600 - select(_e20999.member_2, (_e20999.member_2 + _e20982), _e20986));
let _e21028 = (((_e21021 * _e21018) + (_e21022 * _e21019)) + (_e21023 * _e21020));
let _e21033 = (((_e21021 * _e613) + (_e21022 * _e626)) + (_e21023 * _e639));
let _e21038 = (((_e21018 * _e613) + (_e21019 * _e626)) + (_e21020 * _e639));
let _e21041 = ((_e21019 * _e639) - (_e21020 * _e626));
let _e21044 = ((_e21020 * _e613) - (_e21018 * _e639));
let _e21047 = ((_e21018 * _e626) - (_e21019 * _e613));
let _e21052 = (((_e21041 * _e21041) + (_e21044 * _e21044)) + (_e21047 * _e21047));
let _e21055 = (1f / select(1e-9f, _e21052, (_e21052 > 1e-9f)));
let _e21058 = ((_e21028 - (_e21038 * _e21033)) * _e21055);
let _e21061 = (((_e21038 * _e21028) - _e21033) * _e21055);
let _e21067 = -(_e21038);
let _e21070 = global_1.member.member_13.member_2;
let _e21071 = (_e21070 * _e21070);
let _e21075 = ((1f + _e21071) - ((2f * _e21070) * _e21067));
let _e21077 = select(1e-9f, _e21075, (_e21075 > 1e-9f));
let _e21089 = global_1.member.member_13.member_3;
if (_e21089 == 2u) {
let _e21094 = (0.5f - (0.5f * _e21067));
let _e21096 = select(0f, _e21094, (_e21094 > 0f));
let _e21100 = (sqrt(select(0f, _e21096, (_e21096 > 0f))) * 255f);
let _e21101 = (255f - 1f);
let _e21103 = select(0f, _e21100, (_e21100 > 0f));
let _e21105 = select(_e21101, _e21103, (_e21103 < _e21101));
let _e21112 = select(0i, select(select(i32(_e21105), i32(-2147483648), (_e21105 < -2147483600f)), 2147483647i, (_e21105 > 2147483500f)), (_e21105 == _e21105));
let _e21116 = (_e21112 - select(0i, 1i, (_e21105 < f32(_e21112))));
let _e21119 = global_1.member.member_13.member_11;
let _e21120 = bitcast<i32>(_e21119);
let _e21121 = (_e21120 + _e21116);
let _e21123 = (bitcast<i32>(_e265) - 1i);
let _e21125 = select(_e21123, _e21121, (_e21121 < _e21123));
let _e21130 = global_2.member[bitcast<u32>(select(0i, _e21125, (_e21125 > 0i)))];
let _e21132 = (_e21120 + (_e21116 + 1i));
let _e21134 = select(_e21123, _e21132, (_e21132 < _e21123));
let _e21139 = global_2.member[bitcast<u32>(select(0i, _e21134, (_e21134 > 0i)))];
phi_59235_ = (_e21130 + ((_e21139 - _e21130) * (_e21100 - f32(_e21116))));
} else {
phi_59235_ = select(((1f - _e21071) / (_e21077 * sqrt(select(0f, _e21077, (_e21077 > 0f))))), (0.75f * (1f + (_e21067 * _e21067))), (_e21089 == 1u));
}
let _e21146 = phi_59235_;
let _e21149 = (_e21016 * (_e21146 * (0.25f / 3.1415927f)));
let _e21150 = (_e21058 - _e20935);
let _e21153 = (_e21061 + select(0f, _e21150, (_e21150 > 0f)));
let _e21156 = global_1.member.member_13.member_1;
let _e21165 = global_1.member.member_13.member;
let _e21170 = -((_e21165.member * _e21153));
let _e21172 = select(-87f, _e21170, (_e21170 > -87f));
let _e21174 = select(88f, _e21172, (_e21172 < 88f));
let _e21176 = ((_e21174 * 1.442695f) + 0.5f);
let _e21178 = select(-127f, _e21176, (_e21176 > -127f));
let _e21180 = select(128f, _e21178, (_e21178 < 128f));
let _e21187 = select(0i, select(select(i32(_e21180), i32(-2147483648), (_e21180 < -2147483600f)), 2147483647i, (_e21180 > 2147483500f)), (_e21180 == _e21180));
let _e21191 = (_e21187 - select(0i, 1i, (_e21180 < f32(_e21187))));
let _e21192 = f32(_e21191);
let _e21196 = ((_e21174 - (_e21192 * 0.6933594f)) - (_e21192 * -2.1219444e-4f));
let _e21218 = -((_e21165.member_1 * _e21153));
let _e21220 = select(-87f, _e21218, (_e21218 > -87f));
let _e21222 = select(88f, _e21220, (_e21220 < 88f));
let _e21224 = ((_e21222 * 1.442695f) + 0.5f);
let _e21226 = select(-127f, _e21224, (_e21224 > -127f));
let _e21228 = select(128f, _e21226, (_e21226 < 128f));
let _e21235 = select(0i, select(select(i32(_e21228), i32(-2147483648), (_e21228 < -2147483600f)), 2147483647i, (_e21228 > 2147483500f)), (_e21228 == _e21228));
let _e21239 = (_e21235 - select(0i, 1i, (_e21228 < f32(_e21235))));
let _e21240 = f32(_e21239);
let _e21244 = ((_e21222 - (_e21240 * 0.6933594f)) - (_e21240 * -2.1219444e-4f));
let _e21266 = -((_e21165.member_2 * _e21153));
let _e21268 = select(-87f, _e21266, (_e21266 > -87f));
let _e21270 = select(88f, _e21268, (_e21268 < 88f));
let _e21272 = ((_e21270 * 1.442695f) + 0.5f);
let _e21274 = select(-127f, _e21272, (_e21272 > -127f));
let _e21276 = select(128f, _e21274, (_e21274 < 128f));
let _e21283 = select(0i, select(select(i32(_e21276), i32(-2147483648), (_e21276 < -2147483600f)), 2147483647i, (_e21276 > 2147483500f)), (_e21276 == _e21276));
let _e21287 = (_e21283 - select(0i, 1i, (_e21276 < f32(_e21283))));
let _e21288 = f32(_e21287);
let _e21292 = ((_e21270 - (_e21288 * 0.6933594f)) - (_e21288 * -2.1219444e-4f));
let _e21319 = select(0f, _e21058, (((_e21061 >= 0f) && (_e21061 < _e691)) && (_e21058 > 0f)));
if _e453 {
phi_59480_ = type_23(_e20863, _e20770);
} else {
phi_59480_ = type_23(_e20770, _e20863);
}
let _e21330 = phi_59480_;
let _e21333 = (_e20864 && (((_e21319 > 0f) && (_e21319 < _e20943)) && true));
let _e21336 = global_1.member.member_18.member;
let _e21337 = (((select(_e20889, (1f - _e20889), (_e20874 >= 0f)) - select(_e20908, (1f - _e20908), (_e20893 >= 0f))) * (1f / _e20871)) * _e21336);
let _e21341 = select(0f, (((((_e652 * _e21156.member) * ((1f + (_e21196 * (1f + (_e21196 * (0.5f + (_e21196 * (0.16666667f + (_e21196 * (0.041666668f + (_e21196 * (0.008333334f + (_e21196 * (0.001388889f + (_e21196 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21191 + 127i)) << bitcast<u32>(23i))))) * _e21149) * 1f) * _e21337), _e21333);
let _e21342 = select(0f, (((((_e665 * _e21156.member_1) * ((1f + (_e21244 * (1f + (_e21244 * (0.5f + (_e21244 * (0.16666667f + (_e21244 * (0.041666668f + (_e21244 * (0.008333334f + (_e21244 * (0.001388889f + (_e21244 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21239 + 127i)) << bitcast<u32>(23i))))) * _e21149) * 1f) * _e21337), _e21333);
let _e21343 = select(0f, (((((_e678 * _e21156.member_2) * ((1f + (_e21292 * (1f + (_e21292 * (0.5f + (_e21292 * (0.16666667f + (_e21292 * (0.041666668f + (_e21292 * (0.008333334f + (_e21292 * (0.001388889f + (_e21292 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21287 + 127i)) << bitcast<u32>(23i))))) * _e21149) * 1f) * _e21337), _e21333);
let _e21347 = (bitcast<f32>((bitcast<u32>(_e21341) & 2147483647u)) >= 1073741800f);
let _e21348 = (1f / 1048576f);
let _e21351 = ((_e21341 * select(1f, _e21348, _e21347)) + 0.5f);
let _e21353 = select(-1073741800f, _e21351, (_e21351 > -1073741800f));
let _e21355 = select(1073741800f, _e21353, (_e21353 < 1073741800f));
let _e21362 = select(0i, select(select(i32(_e21355), i32(-2147483648), (_e21355 < -2147483600f)), 2147483647i, (_e21355 > 2147483500f)), (_e21355 == _e21355));
let _e21366 = (_e21362 - select(0i, 1i, (_e21355 < f32(_e21362))));
let _e21367 = select(0i, 20i, _e21347);
let _e21371 = (bitcast<u32>(_e21366) << bitcast<u32>((_e21367 & 31i)));
let _e21378 = bitcast<u32>(((_e21366 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e21367) & 31i))));
let _e21382 = (bitcast<f32>((bitcast<u32>(_e21342) & 2147483647u)) >= 1073741800f);
let _e21385 = ((_e21342 * select(1f, _e21348, _e21382)) + 0.5f);
let _e21387 = select(-1073741800f, _e21385, (_e21385 > -1073741800f));
let _e21389 = select(1073741800f, _e21387, (_e21387 < 1073741800f));
let _e21396 = select(0i, select(select(i32(_e21389), i32(-2147483648), (_e21389 < -2147483600f)), 2147483647i, (_e21389 > 2147483500f)), (_e21389 == _e21389));
let _e21400 = (_e21396 - select(0i, 1i, (_e21389 < f32(_e21396))));
let _e21401 = select(0i, 20i, _e21382);
let _e21405 = (bitcast<u32>(_e21400) << bitcast<u32>((_e21401 & 31i)));
let _e21412 = bitcast<u32>(((_e21400 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e21401) & 31i))));
let _e21416 = (bitcast<f32>((bitcast<u32>(_e21343) & 2147483647u)) >= 1073741800f);
let _e21419 = ((_e21343 * select(1f, _e21348, _e21416)) + 0.5f);
let _e21421 = select(-1073741800f, _e21419, (_e21419 > -1073741800f));
let _e21423 = select(1073741800f, _e21421, (_e21421 < 1073741800f));
let _e21430 = select(0i, select(select(i32(_e21423), i32(-2147483648), (_e21423 < -2147483600f)), 2147483647i, (_e21423 > 2147483500f)), (_e21423 == _e21423));
let _e21434 = (_e21430 - select(0i, 1i, (_e21423 < f32(_e21430))));
let _e21435 = select(0i, 20i, _e21416);
let _e21439 = (bitcast<u32>(_e21434) << bitcast<u32>((_e21435 & 31i)));
let _e21446 = bitcast<u32>(((_e21434 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e21435) & 31i))));
let _e21451 = bitcast<i32>(bitcast<u32>((((_e21330.member_1 * _e14761) + _e21330.member) * 6i)));
if ((_e21371 | _e21378) == 0u) {
} else {
let _e21454 = bitcast<u32>(_e21451);
if (_e21454 < _e270) {
let _e21458 = atomicAdd((&global_8.member[_e21454]), _e21371);
phi_59713_ = _e21458;
} else {
phi_59713_ = 0u;
}
let _e21460 = phi_59713_;
let _e21464 = (_e21378 + select(0u, 1u, ((_e21460 + _e21371) < _e21371)));
if (_e21464 == 0u) {
} else {
let _e21466 = (_e21454 + 1u);
if (_e21466 < _e270) {
let _e21470 = atomicAdd((&global_8.member[_e21466]), _e21464);
}
}
}
if ((_e21405 | _e21412) == 0u) {
} else {
let _e21474 = bitcast<u32>((_e21451 + 2i));
if (_e21474 < _e270) {
let _e21478 = atomicAdd((&global_8.member[_e21474]), _e21405);
phi_59743_ = _e21478;
} else {
phi_59743_ = 0u;
}
let _e21480 = phi_59743_;
let _e21484 = (_e21412 + select(0u, 1u, ((_e21480 + _e21405) < _e21405)));
if (_e21484 == 0u) {
} else {
let _e21486 = (_e21474 + 1u);
if (_e21486 < _e270) {
let _e21490 = atomicAdd((&global_8.member[_e21486]), _e21484);
}
}
}
if ((_e21439 | _e21446) == 0u) {
} else {
let _e21494 = bitcast<u32>((_e21451 + 4i));
if (_e21494 < _e270) {
let _e21498 = atomicAdd((&global_8.member[_e21494]), _e21439);
phi_59773_ = _e21498;
} else {
phi_59773_ = 0u;
}
let _e21500 = phi_59773_;
let _e21504 = (_e21446 + select(0u, 1u, ((_e21500 + _e21439) < _e21439)));
if (_e21504 == 0u) {
} else {
let _e21506 = (_e21494 + 1u);
if (_e21506 < _e270) {
let _e21510 = atomicAdd((&global_8.member[_e21506]), _e21504);
}
}
}
phi_58704_ = (_e20861 + 1i);
} else {
phi_58704_ = i32();
}
let _e21513 = phi_58704_;
continue;
continuing {
phi_58703_ = _e21513;
break if !(_e20864);
}
}
phi_58550_ = (_e20767 + 1i);
} else {
phi_58550_ = i32();
}
let _e21517 = phi_58550_;
continue;
continuing {
phi_58549_ = _e21517;
break if !(_e20768);
}
}
} else {
if (_e20764 == 1u) {
phi_59822_ = 0i;
loop {
let _e21521 = phi_59822_;
let _e21522 = (_e21521 < 16i);
if _e21522 {
let _e21524 = (_e14806 + (_e21521 & 15i));
let _e21526 = (f32(_e21524) + 0.5f);
let _e21528 = ((_e21526 * 1f) - 0.5f);
let _e21532 = (-(((_e416 * _e21528) + _e442)) / _e429);
let _e21539 = bitcast<f32>((bitcast<u32>(((_e466 * _e21528) + ((_e479 * _e21532) + _e492))) & 2147483647u));
let _e21546 = bitcast<f32>((bitcast<u32>(((_e505 * _e21528) + ((_e518 * _e21532) + _e531))) & 2147483647u));
let _e21550 = (((0.5f * (_e21539 + _e21546)) / _e534) + _e717);
let _e21551 = (1f / 1f);
let _e21559 = ((((_e21532 + _e21550) + 0.5f) * _e21551) - 0.5f);
let _e21560 = f32(_e20750);
let _e21561 = f32(_e20748);
let _e21562 = (_e21560 - 1f);
let _e21564 = select(_e21562, _e21559, (_e21559 > _e21562));
let _e21566 = select(_e21561, _e21564, (_e21564 < _e21561));
let _e21573 = select(0i, select(select(i32(_e21566), i32(-2147483648), (_e21566 < -2147483600f)), 2147483647i, (_e21566 > 2147483500f)), (_e21566 == _e21566));
let _e21578 = (((((_e21532 - _e21550) + 0.5f) * _e21551) - 0.5f) + 1f);
let _e21579 = (_e21561 + 1f);
let _e21581 = select(_e21560, _e21578, (_e21578 > _e21560));
let _e21583 = select(_e21579, _e21581, (_e21581 < _e21579));
let _e21590 = select(0i, select(select(i32(_e21583), i32(-2147483648), (_e21583 < -2147483600f)), 2147483647i, (_e21583 > 2147483500f)), (_e21583 == _e21583));
let _e21601 = ((1e-4f * 1f) * _e534);
let _e21603 = select(_e21546, _e21539, (_e21539 > _e21546));
let _e21605 = select(_e21601, _e21603, (_e21603 > _e21601));
let _e21607 = select(_e21546, _e21539, (_e21539 < _e21546));
let _e21609 = select(_e21601, _e21607, (_e21607 > _e21601));
let _e21611 = (0.5f * (_e21605 + _e21609));
let _e21612 = (0.5f / _e21609);
let _e21613 = (1f / _e21605);
phi_59976_ = 0i;
loop {
let _e21615 = phi_59976_;
let _e21617 = (((_e21590 - select(0i, 1i, (_e21583 < f32(_e21590)))) + (_e21521 >> bitcast<u32>(4u))) + bitcast<i32>(_e21615));
let _e21618 = (_e21617 <= select(-1i, (_e21573 - select(0i, 1i, (_e21566 < f32(_e21573)))), (_e21524 <= _e14810)));
if _e21618 {
let _e21620 = (f32(_e21617) + 0.5f);
let _e21624 = ((((_e21620 * 1f) - 0.5f) - _e21532) * _e534);
let _e21625 = (_e534 * 1f);
let _e21627 = (0.5f * _e21625);
let _e21628 = (_e21624 + _e21627);
let _e21629 = -(_e21628);
let _e21632 = (_e21611 - select(_e21629, _e21628, (_e21628 > _e21629)));
let _e21634 = select(0f, _e21632, (_e21632 > 0f));
let _e21636 = select(_e21609, _e21634, (_e21634 < _e21609));
let _e21639 = (_e21632 - _e21609);
let _e21643 = (((_e21636 * (_e21636 * _e21612)) + select(0f, _e21639, (_e21639 > 0f))) * _e21613);
let _e21647 = (_e21624 - _e21627);
let _e21648 = -(_e21647);
let _e21651 = (_e21611 - select(_e21648, _e21647, (_e21647 > _e21648)));
let _e21653 = select(0f, _e21651, (_e21651 > 0f));
let _e21655 = select(_e21609, _e21653, (_e21653 < _e21609));
let _e21658 = (_e21651 - _e21609);
let _e21662 = (((_e21655 * (_e21655 * _e21612)) + select(0f, _e21658, (_e21658 > 0f))) * _e21613);
if _e453 {
phi_60081_ = type_23(_e21617, _e21524);
} else {
phi_60081_ = type_23(_e21524, _e21617);
}
let _e21671 = phi_60081_;
local_34 = bitcast<i32>((_e14757 * _e14760));
local_35 = ((_e21671.member_1 * _e14761) + _e21671.member);
let _e21678 = local_34;
let _e21679 = local_35;
let _e21680 = (_e21678 + _e21679);
let _e21682 = (bitcast<i32>(_e259) - 1i);
let _e21684 = select(_e21682, _e21680, (_e21680 < _e21682));
let _e21689 = global_5.member[bitcast<u32>(select(0i, _e21684, (_e21684 > 0i)))];
let _e21690 = local_35;
let _e21692 = select(_e21682, _e21690, (_e21690 < _e21682));
let _e21697 = global_5.member[bitcast<u32>(select(0i, _e21692, (_e21692 > 0i)))];
let _e21700 = f32(_e14761);
let _e21701 = f32(_e14762);
let _e21708 = global_1.member.member_2.member;
let _e21709 = (((((f32(_e21671.member) + 0.5f) / _e21700) * 2f) - 1f) * _e21708);
let _e21716 = global_1.member.member_2.member_1;
let _e21717 = ((1f - (((f32(_e21671.member_1) + 0.5f) / _e21701) * 2f)) * _e21716);
let _e21719 = global_1.member.member_3;
let _e21727 = global_1.member.member_4;
let _e21734 = ((_e21719.member * _e21709) + (_e21727.member * _e21717));
let _e21735 = ((_e21719.member_1 * _e21709) + (_e21727.member_1 * _e21717));
let _e21736 = ((_e21719.member_2 * _e21709) + (_e21727.member_2 * _e21717));
let _e21739 = global_1.member.member_2.member_3;
let _e21740 = (_e21739 != 0u);
let _e21742 = global_1.member.member_5;
let _e21749 = select((_e21742.member + _e21734), _e21742.member, _e21740);
let _e21750 = select((_e21742.member_1 + _e21735), _e21742.member_1, _e21740);
let _e21751 = select((_e21742.member_2 + _e21736), _e21742.member_2, _e21740);
let _e21753 = global_1.member.member_6;
let _e21767 = (((_e21749 * _e21749) + (_e21750 * _e21750)) + (_e21751 * _e21751));
let _e21770 = sqrt(select(0f, _e21767, (_e21767 > 0f)));
let _e21771 = (1f / _e21770);
let _e21772 = (_e21749 * _e21771);
let _e21773 = (_e21750 * _e21771);
let _e21774 = (_e21751 * _e21771);
let _e21775 = (_e575 - select(_e21753.member, (_e21753.member + _e21734), _e21740));
let _e21776 = (_e587 - select(_e21753.member_1, (_e21753.member_1 + _e21735), _e21740));
let _e21777 = (_e600 - select(_e21753.member_2, (_e21753.member_2 + _e21736), _e21740));
let _e21782 = (((_e21775 * _e21772) + (_e21776 * _e21773)) + (_e21777 * _e21774));
let _e21787 = (((_e21775 * _e613) + (_e21776 * _e626)) + (_e21777 * _e639));
let _e21792 = (((_e21772 * _e613) + (_e21773 * _e626)) + (_e21774 * _e639));
let _e21795 = ((_e21773 * _e639) - (_e21774 * _e626));
let _e21798 = ((_e21774 * _e613) - (_e21772 * _e639));
let _e21801 = ((_e21772 * _e626) - (_e21773 * _e613));
let _e21806 = (((_e21795 * _e21795) + (_e21798 * _e21798)) + (_e21801 * _e21801));
let _e21809 = (1f / select(1e-9f, _e21806, (_e21806 > 1e-9f)));
let _e21812 = ((_e21782 - (_e21792 * _e21787)) * _e21809);
let _e21815 = (((_e21792 * _e21782) - _e21787) * _e21809);
let _e21821 = -(_e21792);
let _e21824 = global_1.member.member_13.member_2;
let _e21825 = (_e21824 * _e21824);
let _e21829 = ((1f + _e21825) - ((2f * _e21824) * _e21821));
let _e21831 = select(1e-9f, _e21829, (_e21829 > 1e-9f));
let _e21843 = global_1.member.member_13.member_3;
if (_e21843 == 2u) {
let _e21848 = (0.5f - (0.5f * _e21821));
let _e21850 = select(0f, _e21848, (_e21848 > 0f));
let _e21854 = (sqrt(select(0f, _e21850, (_e21850 > 0f))) * 255f);
let _e21855 = (255f - 1f);
let _e21857 = select(0f, _e21854, (_e21854 > 0f));
let _e21859 = select(_e21855, _e21857, (_e21857 < _e21855));
let _e21866 = select(0i, select(select(i32(_e21859), i32(-2147483648), (_e21859 < -2147483600f)), 2147483647i, (_e21859 > 2147483500f)), (_e21859 == _e21859));
let _e21870 = (_e21866 - select(0i, 1i, (_e21859 < f32(_e21866))));
let _e21873 = global_1.member.member_13.member_11;
let _e21874 = bitcast<i32>(_e21873);
let _e21875 = (_e21874 + _e21870);
let _e21877 = (bitcast<i32>(_e265) - 1i);
let _e21879 = select(_e21877, _e21875, (_e21875 < _e21877));
let _e21884 = global_2.member[bitcast<u32>(select(0i, _e21879, (_e21879 > 0i)))];
let _e21886 = (_e21874 + (_e21870 + 1i));
let _e21888 = select(_e21877, _e21886, (_e21886 < _e21877));
let _e21893 = global_2.member[bitcast<u32>(select(0i, _e21888, (_e21888 > 0i)))];
phi_60508_ = (_e21884 + ((_e21893 - _e21884) * (_e21854 - f32(_e21870))));
} else {
phi_60508_ = select(((1f - _e21825) / (_e21831 * sqrt(select(0f, _e21831, (_e21831 > 0f))))), (0.75f * (1f + (_e21821 * _e21821))), (_e21843 == 1u));
}
let _e21900 = phi_60508_;
let _e21903 = (_e21770 * (_e21900 * (0.25f / 3.1415927f)));
let _e21904 = (_e21812 - _e21689);
let _e21907 = (_e21815 + select(0f, _e21904, (_e21904 > 0f)));
let _e21910 = global_1.member.member_13.member_1;
let _e21919 = global_1.member.member_13.member;
let _e21924 = -((_e21919.member * _e21907));
let _e21926 = select(-87f, _e21924, (_e21924 > -87f));
let _e21928 = select(88f, _e21926, (_e21926 < 88f));
let _e21930 = ((_e21928 * 1.442695f) + 0.5f);
let _e21932 = select(-127f, _e21930, (_e21930 > -127f));
let _e21934 = select(128f, _e21932, (_e21932 < 128f));
let _e21941 = select(0i, select(select(i32(_e21934), i32(-2147483648), (_e21934 < -2147483600f)), 2147483647i, (_e21934 > 2147483500f)), (_e21934 == _e21934));
let _e21945 = (_e21941 - select(0i, 1i, (_e21934 < f32(_e21941))));
let _e21946 = f32(_e21945);
let _e21950 = ((_e21928 - (_e21946 * 0.6933594f)) - (_e21946 * -2.1219444e-4f));
let _e21972 = -((_e21919.member_1 * _e21907));
let _e21974 = select(-87f, _e21972, (_e21972 > -87f));
let _e21976 = select(88f, _e21974, (_e21974 < 88f));
let _e21978 = ((_e21976 * 1.442695f) + 0.5f);
let _e21980 = select(-127f, _e21978, (_e21978 > -127f));
let _e21982 = select(128f, _e21980, (_e21980 < 128f));
let _e21989 = select(0i, select(select(i32(_e21982), i32(-2147483648), (_e21982 < -2147483600f)), 2147483647i, (_e21982 > 2147483500f)), (_e21982 == _e21982));
let _e21993 = (_e21989 - select(0i, 1i, (_e21982 < f32(_e21989))));
let _e21994 = f32(_e21993);
let _e21998 = ((_e21976 - (_e21994 * 0.6933594f)) - (_e21994 * -2.1219444e-4f));
let _e22020 = -((_e21919.member_2 * _e21907));
let _e22022 = select(-87f, _e22020, (_e22020 > -87f));
let _e22024 = select(88f, _e22022, (_e22022 < 88f));
let _e22026 = ((_e22024 * 1.442695f) + 0.5f);
let _e22028 = select(-127f, _e22026, (_e22026 > -127f));
let _e22030 = select(128f, _e22028, (_e22028 < 128f));
let _e22037 = select(0i, select(select(i32(_e22030), i32(-2147483648), (_e22030 < -2147483600f)), 2147483647i, (_e22030 > 2147483500f)), (_e22030 == _e22030));
let _e22041 = (_e22037 - select(0i, 1i, (_e22030 < f32(_e22037))));
let _e22042 = f32(_e22041);
let _e22046 = ((_e22024 - (_e22042 * 0.6933594f)) - (_e22042 * -2.1219444e-4f));
let _e22073 = select(0f, _e21812, (((_e21815 >= 0f) && (_e21815 < _e691)) && (_e21812 > 0f)));
let _e22075 = ((_e766 + _e20752) + _e20756);
let _e22076 = (_e22075 & 31u);
let _e22078 = (1u << bitcast<u32>(_e22076));
let _e22087 = bitcast<i32>((((_e14757 + _e22078) - 1u) >> bitcast<u32>(_e22076)));
let _e22088 = bitcast<i32>((((_e14760 + _e22078) - 1u) >> bitcast<u32>(_e22076)));
if _e453 {
phi_60779_ = type_23(_e22088, _e22087);
} else {
phi_60779_ = type_23(_e22087, _e22088);
}
let _e22092 = phi_60779_;
let _e22097 = f32((1i << bitcast<u32>(_e22076)));
let _e22098 = (1f / _e22097);
let _e22100 = ((_e21526 * _e22098) - 0.5f);
let _e22102 = ((_e21620 * _e22098) - 0.5f);
let _e22104 = select(-1f, _e22100, (_e22100 > -1f));
let _e22106 = select(1e6f, _e22104, (_e22104 < 1e6f));
let _e22113 = select(0i, select(select(i32(_e22106), i32(-2147483648), (_e22106 < -2147483600f)), 2147483647i, (_e22106 > 2147483500f)), (_e22106 == _e22106));
let _e22117 = (_e22113 - select(0i, 1i, (_e22106 < f32(_e22113))));
let _e22119 = select(-1f, _e22102, (_e22102 > -1f));
let _e22121 = select(1e6f, _e22119, (_e22119 < 1e6f));
let _e22128 = select(0i, select(select(i32(_e22121), i32(-2147483648), (_e22121 < -2147483600f)), 2147483647i, (_e22121 > 2147483500f)), (_e22121 == _e22121));
let _e22132 = (_e22128 - select(0i, 1i, (_e22121 < f32(_e22128))));
let _e22134 = (_e22100 - f32(_e22117));
let _e22136 = (_e22102 - f32(_e22132));
let _e22137 = (1f - _e22134);
let _e22138 = (1f - _e22136);
let _e22141 = select(_e22117, 0i, (_e22117 < 0i));
let _e22142 = (_e22141 >= _e22092.member);
if _e22142 {
phi_60857_ = (_e22092.member - 1i);
} else {
phi_60857_ = _e22141;
}
let _e22145 = phi_60857_;
let _e22147 = select(_e22132, 0i, (_e22132 < 0i));
let _e22148 = (_e22147 >= _e22092.member_1);
if _e22148 {
phi_60868_ = (_e22092.member_1 - 1i);
} else {
phi_60868_ = _e22147;
}
let _e22151 = phi_60868_;
let _e22155 = (((f32(_e22145) + 0.5f) * _e22097) - 0.5f);
let _e22159 = (((f32(_e22151) + 0.5f) * _e22097) - 0.5f);
if _e453 {
phi_60896_ = type_23(_e22151, _e22145);
} else {
phi_60896_ = type_23(_e22145, _e22151);
}
let _e22165 = phi_60896_;
let _e22171 = bitcast<i32>(((_e14757 + 1u) >> bitcast<u32>(1u)));
let _e22174 = global_1.member.member_18.member_6;
let _e22177 = global_1.member.member_18.member_7;
let _e22180 = global_1.member.member_18.member_8;
let _e22181 = (_e22075 == 0u);
if _e22181 {
phi_60947_ = 0u;
} else {
if (_e22075 == 1u) {
phi_60946_ = 0u;
} else {
if (_e22075 == 2u) {
phi_60945_ = _e22174;
} else {
phi_60945_ = select(_e22180, _e22177, (_e22075 == 3u));
}
let _e22187 = phi_60945_;
phi_60946_ = _e22187;
}
let _e22189 = phi_60946_;
phi_60947_ = _e22189;
}
let _e22191 = phi_60947_;
local_32 = (((bitcast<i32>(_e22191) + _e22165.member_1) * _e22171) + _e22165.member);
let _e22196 = local_32;
let _e22198 = (bitcast<i32>(_e262) - 1i);
let _e22200 = select(_e22198, _e22196, (_e22196 < _e22198));
let _e22205 = global_6.member[bitcast<u32>(select(0i, _e22200, (_e22200 > 0i)))];
let _e22210 = (((((select(_e22155, _e22159, _e453) + 0.5f) / _e21700) * 2f) - 1f) * _e21708);
let _e22215 = ((1f - (((select(_e22159, _e22155, _e453) + 0.5f) / _e21701) * 2f)) * _e21716);
let _e22222 = ((_e21719.member * _e22210) + (_e21727.member * _e22215));
let _e22223 = ((_e21719.member_1 * _e22210) + (_e21727.member_1 * _e22215));
let _e22224 = ((_e21719.member_2 * _e22210) + (_e21727.member_2 * _e22215));
let _e22228 = select((_e21742.member + _e22222), _e21742.member, _e21740);
let _e22229 = select((_e21742.member_1 + _e22223), _e21742.member_1, _e21740);
let _e22230 = select((_e21742.member_2 + _e22224), _e21742.member_2, _e21740);
let _e22241 = (((_e22228 * _e22228) + (_e22229 * _e22229)) + (_e22230 * _e22230));
let _e22245 = (1f / sqrt(select(0f, _e22241, (_e22241 > 0f))));
let _e22246 = (_e22228 * _e22245);
let _e22247 = (_e22229 * _e22245);
let _e22248 = (_e22230 * _e22245);
let _e22249 = (_e575 - select(_e21753.member, (_e21753.member + _e22222), _e21740));
let _e22250 = (_e587 - select(_e21753.member_1, (_e21753.member_1 + _e22223), _e21740));
let _e22251 = (_e600 - select(_e21753.member_2, (_e21753.member_2 + _e22224), _e21740));
let _e22256 = (((_e22249 * _e22246) + (_e22250 * _e22247)) + (_e22251 * _e22248));
let _e22261 = (((_e22249 * _e613) + (_e22250 * _e626)) + (_e22251 * _e639));
let _e22266 = (((_e22246 * _e613) + (_e22247 * _e626)) + (_e22248 * _e639));
let _e22269 = ((_e22247 * _e639) - (_e22248 * _e626));
let _e22272 = ((_e22248 * _e613) - (_e22246 * _e639));
let _e22275 = ((_e22246 * _e626) - (_e22247 * _e613));
let _e22280 = (((_e22269 * _e22269) + (_e22272 * _e22272)) + (_e22275 * _e22275));
let _e22283 = (1f / select(1e-9f, _e22280, (_e22280 > 1e-9f)));
let _e22286 = ((_e22256 - (_e22266 * _e22261)) * _e22283);
let _e22289 = (((_e22266 * _e22256) - _e22261) * _e22283);
let _e22295 = select(0f, _e22286, (((_e22289 >= 0f) && (_e22289 < _e691)) && (_e22286 > 0f)));
let _e22297 = (_e22145 << bitcast<u32>(_e22076));
let _e22309 = (_e22117 + 1i);
let _e22312 = select(_e22309, 0i, (_e22309 < 0i));
let _e22313 = (_e22312 >= _e22092.member);
if _e22313 {
phi_61608_ = (_e22092.member - 1i);
} else {
phi_61608_ = _e22312;
}
let _e22316 = phi_61608_;
if _e22148 {
phi_61619_ = (_e22092.member_1 - 1i);
} else {
phi_61619_ = _e22147;
}
let _e22319 = phi_61619_;
let _e22323 = (((f32(_e22316) + 0.5f) * _e22097) - 0.5f);
let _e22327 = (((f32(_e22319) + 0.5f) * _e22097) - 0.5f);
if _e453 {
phi_61647_ = type_23(_e22319, _e22316);
} else {
phi_61647_ = type_23(_e22316, _e22319);
}
let _e22333 = phi_61647_;
if _e22181 {
phi_61698_ = 0u;
} else {
if (_e22075 == 1u) {
phi_61697_ = 0u;
} else {
if (_e22075 == 2u) {
phi_61696_ = _e22174;
} else {
phi_61696_ = select(_e22180, _e22177, (_e22075 == 3u));
}
let _e22341 = phi_61696_;
phi_61697_ = _e22341;
}
let _e22343 = phi_61697_;
phi_61698_ = _e22343;
}
let _e22345 = phi_61698_;
local_30 = (((bitcast<i32>(_e22345) + _e22333.member_1) * _e22171) + _e22333.member);
let _e22350 = local_30;
let _e22352 = select(_e22198, _e22350, (_e22350 < _e22198));
let _e22357 = global_6.member[bitcast<u32>(select(0i, _e22352, (_e22352 > 0i)))];
let _e22362 = (((((select(_e22323, _e22327, _e453) + 0.5f) / _e21700) * 2f) - 1f) * _e21708);
let _e22367 = ((1f - (((select(_e22327, _e22323, _e453) + 0.5f) / _e21701) * 2f)) * _e21716);
let _e22374 = ((_e21719.member * _e22362) + (_e21727.member * _e22367));
let _e22375 = ((_e21719.member_1 * _e22362) + (_e21727.member_1 * _e22367));
let _e22376 = ((_e21719.member_2 * _e22362) + (_e21727.member_2 * _e22367));
let _e22380 = select((_e21742.member + _e22374), _e21742.member, _e21740);
let _e22381 = select((_e21742.member_1 + _e22375), _e21742.member_1, _e21740);
let _e22382 = select((_e21742.member_2 + _e22376), _e21742.member_2, _e21740);
let _e22393 = (((_e22380 * _e22380) + (_e22381 * _e22381)) + (_e22382 * _e22382));
let _e22397 = (1f / sqrt(select(0f, _e22393, (_e22393 > 0f))));
let _e22398 = (_e22380 * _e22397);
let _e22399 = (_e22381 * _e22397);
let _e22400 = (_e22382 * _e22397);
let _e22401 = (_e575 - select(_e21753.member, (_e21753.member + _e22374), _e21740));
let _e22402 = (_e587 - select(_e21753.member_1, (_e21753.member_1 + _e22375), _e21740));
let _e22403 = (_e600 - select(_e21753.member_2, (_e21753.member_2 + _e22376), _e21740));
let _e22408 = (((_e22401 * _e22398) + (_e22402 * _e22399)) + (_e22403 * _e22400));
let _e22413 = (((_e22401 * _e613) + (_e22402 * _e626)) + (_e22403 * _e639));
let _e22418 = (((_e22398 * _e613) + (_e22399 * _e626)) + (_e22400 * _e639));
let _e22421 = ((_e22399 * _e639) - (_e22400 * _e626));
let _e22424 = ((_e22400 * _e613) - (_e22398 * _e639));
let _e22427 = ((_e22398 * _e626) - (_e22399 * _e613));
let _e22432 = (((_e22421 * _e22421) + (_e22424 * _e22424)) + (_e22427 * _e22427));
let _e22435 = (1f / select(1e-9f, _e22432, (_e22432 > 1e-9f)));
let _e22438 = ((_e22408 - (_e22418 * _e22413)) * _e22435);
let _e22441 = (((_e22418 * _e22408) - _e22413) * _e22435);
let _e22447 = select(0f, _e22438, (((_e22441 >= 0f) && (_e22441 < _e691)) && (_e22438 > 0f)));
let _e22449 = (_e22316 << bitcast<u32>(_e22076));
let _e22461 = (_e22132 + 1i);
if _e22142 {
phi_62359_ = (_e22092.member - 1i);
} else {
phi_62359_ = _e22141;
}
let _e22465 = phi_62359_;
let _e22467 = select(_e22461, 0i, (_e22461 < 0i));
let _e22468 = (_e22467 >= _e22092.member_1);
if _e22468 {
phi_62370_ = (_e22092.member_1 - 1i);
} else {
phi_62370_ = _e22467;
}
let _e22471 = phi_62370_;
let _e22475 = (((f32(_e22465) + 0.5f) * _e22097) - 0.5f);
let _e22479 = (((f32(_e22471) + 0.5f) * _e22097) - 0.5f);
if _e453 {
phi_62398_ = type_23(_e22471, _e22465);
} else {
phi_62398_ = type_23(_e22465, _e22471);
}
let _e22485 = phi_62398_;
if _e22181 {
phi_62449_ = 0u;
} else {
if (_e22075 == 1u) {
phi_62448_ = 0u;
} else {
if (_e22075 == 2u) {
phi_62447_ = _e22174;
} else {
phi_62447_ = select(_e22180, _e22177, (_e22075 == 3u));
}
let _e22493 = phi_62447_;
phi_62448_ = _e22493;
}
let _e22495 = phi_62448_;
phi_62449_ = _e22495;
}
let _e22497 = phi_62449_;
local_28 = (((bitcast<i32>(_e22497) + _e22485.member_1) * _e22171) + _e22485.member);
let _e22502 = local_28;
let _e22504 = select(_e22198, _e22502, (_e22502 < _e22198));
let _e22509 = global_6.member[bitcast<u32>(select(0i, _e22504, (_e22504 > 0i)))];
let _e22514 = (((((select(_e22475, _e22479, _e453) + 0.5f) / _e21700) * 2f) - 1f) * _e21708);
let _e22519 = ((1f - (((select(_e22479, _e22475, _e453) + 0.5f) / _e21701) * 2f)) * _e21716);
let _e22526 = ((_e21719.member * _e22514) + (_e21727.member * _e22519));
let _e22527 = ((_e21719.member_1 * _e22514) + (_e21727.member_1 * _e22519));
let _e22528 = ((_e21719.member_2 * _e22514) + (_e21727.member_2 * _e22519));
let _e22532 = select((_e21742.member + _e22526), _e21742.member, _e21740);
let _e22533 = select((_e21742.member_1 + _e22527), _e21742.member_1, _e21740);
let _e22534 = select((_e21742.member_2 + _e22528), _e21742.member_2, _e21740);
let _e22545 = (((_e22532 * _e22532) + (_e22533 * _e22533)) + (_e22534 * _e22534));
let _e22549 = (1f / sqrt(select(0f, _e22545, (_e22545 > 0f))));
let _e22550 = (_e22532 * _e22549);
let _e22551 = (_e22533 * _e22549);
let _e22552 = (_e22534 * _e22549);
let _e22553 = (_e575 - select(_e21753.member, (_e21753.member + _e22526), _e21740));
let _e22554 = (_e587 - select(_e21753.member_1, (_e21753.member_1 + _e22527), _e21740));
let _e22555 = (_e600 - select(_e21753.member_2, (_e21753.member_2 + _e22528), _e21740));
let _e22560 = (((_e22553 * _e22550) + (_e22554 * _e22551)) + (_e22555 * _e22552));
let _e22565 = (((_e22553 * _e613) + (_e22554 * _e626)) + (_e22555 * _e639));
let _e22570 = (((_e22550 * _e613) + (_e22551 * _e626)) + (_e22552 * _e639));
let _e22573 = ((_e22551 * _e639) - (_e22552 * _e626));
let _e22576 = ((_e22552 * _e613) - (_e22550 * _e639));
let _e22579 = ((_e22550 * _e626) - (_e22551 * _e613));
let _e22584 = (((_e22573 * _e22573) + (_e22576 * _e22576)) + (_e22579 * _e22579));
let _e22587 = (1f / select(1e-9f, _e22584, (_e22584 > 1e-9f)));
let _e22590 = ((_e22560 - (_e22570 * _e22565)) * _e22587);
let _e22593 = (((_e22570 * _e22560) - _e22565) * _e22587);
let _e22599 = select(0f, _e22590, (((_e22593 >= 0f) && (_e22593 < _e691)) && (_e22590 > 0f)));
let _e22601 = (_e22465 << bitcast<u32>(_e22076));
if _e22313 {
phi_63110_ = (_e22092.member - 1i);
} else {
phi_63110_ = _e22312;
}
let _e22616 = phi_63110_;
if _e22468 {
phi_63121_ = (_e22092.member_1 - 1i);
} else {
phi_63121_ = _e22467;
}
let _e22619 = phi_63121_;
let _e22623 = (((f32(_e22616) + 0.5f) * _e22097) - 0.5f);
let _e22627 = (((f32(_e22619) + 0.5f) * _e22097) - 0.5f);
if _e453 {
phi_63149_ = type_23(_e22619, _e22616);
} else {
phi_63149_ = type_23(_e22616, _e22619);
}
let _e22633 = phi_63149_;
if _e22181 {
phi_63200_ = 0u;
} else {
if (_e22075 == 1u) {
phi_63199_ = 0u;
} else {
if (_e22075 == 2u) {
phi_63198_ = _e22174;
} else {
phi_63198_ = select(_e22180, _e22177, (_e22075 == 3u));
}
let _e22641 = phi_63198_;
phi_63199_ = _e22641;
}
let _e22643 = phi_63199_;
phi_63200_ = _e22643;
}
let _e22645 = phi_63200_;
local_26 = (((bitcast<i32>(_e22645) + _e22633.member_1) * _e22171) + _e22633.member);
let _e22650 = local_26;
let _e22652 = select(_e22198, _e22650, (_e22650 < _e22198));
let _e22657 = global_6.member[bitcast<u32>(select(0i, _e22652, (_e22652 > 0i)))];
let _e22662 = (((((select(_e22623, _e22627, _e453) + 0.5f) / _e21700) * 2f) - 1f) * _e21708);
let _e22667 = ((1f - (((select(_e22627, _e22623, _e453) + 0.5f) / _e21701) * 2f)) * _e21716);
let _e22674 = ((_e21719.member * _e22662) + (_e21727.member * _e22667));
let _e22675 = ((_e21719.member_1 * _e22662) + (_e21727.member_1 * _e22667));
let _e22676 = ((_e21719.member_2 * _e22662) + (_e21727.member_2 * _e22667));
let _e22680 = select((_e21742.member + _e22674), _e21742.member, _e21740);
let _e22681 = select((_e21742.member_1 + _e22675), _e21742.member_1, _e21740);
let _e22682 = select((_e21742.member_2 + _e22676), _e21742.member_2, _e21740);
let _e22693 = (((_e22680 * _e22680) + (_e22681 * _e22681)) + (_e22682 * _e22682));
let _e22697 = (1f / sqrt(select(0f, _e22693, (_e22693 > 0f))));
let _e22698 = (_e22680 * _e22697);
let _e22699 = (_e22681 * _e22697);
let _e22700 = (_e22682 * _e22697);
let _e22701 = (_e575 - select(_e21753.member, (_e21753.member + _e22674), _e21740));
let _e22702 = (_e587 - select(_e21753.member_1, (_e21753.member_1 + _e22675), _e21740));
let _e22703 = (_e600 - select(_e21753.member_2, (_e21753.member_2 + _e22676), _e21740));
let _e22708 = (((_e22701 * _e22698) + (_e22702 * _e22699)) + (_e22703 * _e22700));
let _e22713 = (((_e22701 * _e613) + (_e22702 * _e626)) + (_e22703 * _e639));
let _e22718 = (((_e22698 * _e613) + (_e22699 * _e626)) + (_e22700 * _e639));
let _e22721 = ((_e22699 * _e639) - (_e22700 * _e626));
let _e22724 = ((_e22700 * _e613) - (_e22698 * _e639));
let _e22727 = ((_e22698 * _e626) - (_e22699 * _e613));
let _e22732 = (((_e22721 * _e22721) + (_e22724 * _e22724)) + (_e22727 * _e22727));
let _e22735 = (1f / select(1e-9f, _e22732, (_e22732 > 1e-9f)));
let _e22738 = ((_e22708 - (_e22718 * _e22713)) * _e22735);
let _e22741 = (((_e22718 * _e22708) - _e22713) * _e22735);
let _e22747 = select(0f, _e22738, (((_e22741 >= 0f) && (_e22741 < _e691)) && (_e22738 > 0f)));
let _e22749 = (_e22616 << bitcast<u32>(_e22076));
let _e22761 = select(((((1f - select(0f, (_e22137 * _e22138), (((select(select(_e766, _e923, (_e22297 >= _e692)), _e845, (_e22297 < _e298)) == _e22075) && (_e22295 > 0f)) && (_e22295 < _e22205)))) - select(0f, (_e22134 * _e22138), (((select(select(_e766, _e923, (_e22449 >= _e692)), _e845, (_e22449 < _e298)) == _e22075) && (_e22447 > 0f)) && (_e22447 < _e22357)))) - select(0f, (_e22137 * _e22136), (((select(select(_e766, _e923, (_e22601 >= _e692)), _e845, (_e22601 < _e298)) == _e22075) && (_e22599 > 0f)) && (_e22599 < _e22509)))) - select(0f, (_e22134 * _e22136), (((select(select(_e766, _e923, (_e22749 >= _e692)), _e845, (_e22749 < _e298)) == _e22075) && (_e22747 > 0f)) && (_e22747 < _e22657)))), 1f, _e22181);
if _e453 {
phi_63870_ = type_23(_e21617, _e21524);
} else {
phi_63870_ = type_23(_e21524, _e21617);
}
let _e22776 = phi_63870_;
let _e22779 = (_e21618 && (((_e22073 > 0f) && (_e22073 < _e21697)) && (bitcast<f32>((bitcast<u32>(_e22761) & 2147483647u)) > 1e-6f)));
let _e22782 = global_1.member.member_18.member;
let _e22783 = (((select(_e21643, (1f - _e21643), (_e21628 >= 0f)) - select(_e21662, (1f - _e21662), (_e21647 >= 0f))) * (1f / _e21625)) * _e22782);
let _e22787 = select(0f, (((((_e652 * _e21910.member) * ((1f + (_e21950 * (1f + (_e21950 * (0.5f + (_e21950 * (0.16666667f + (_e21950 * (0.041666668f + (_e21950 * (0.008333334f + (_e21950 * (0.001388889f + (_e21950 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21945 + 127i)) << bitcast<u32>(23i))))) * _e21903) * _e22761) * _e22783), _e22779);
let _e22788 = select(0f, (((((_e665 * _e21910.member_1) * ((1f + (_e21998 * (1f + (_e21998 * (0.5f + (_e21998 * (0.16666667f + (_e21998 * (0.041666668f + (_e21998 * (0.008333334f + (_e21998 * (0.001388889f + (_e21998 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21993 + 127i)) << bitcast<u32>(23i))))) * _e21903) * _e22761) * _e22783), _e22779);
let _e22789 = select(0f, (((((_e678 * _e21910.member_2) * ((1f + (_e22046 * (1f + (_e22046 * (0.5f + (_e22046 * (0.16666667f + (_e22046 * (0.041666668f + (_e22046 * (0.008333334f + (_e22046 * (0.001388889f + (_e22046 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e22041 + 127i)) << bitcast<u32>(23i))))) * _e21903) * _e22761) * _e22783), _e22779);
let _e22793 = (bitcast<f32>((bitcast<u32>(_e22787) & 2147483647u)) >= 1073741800f);
let _e22794 = (1f / 1048576f);
let _e22797 = ((_e22787 * select(1f, _e22794, _e22793)) + 0.5f);
let _e22799 = select(-1073741800f, _e22797, (_e22797 > -1073741800f));
let _e22801 = select(1073741800f, _e22799, (_e22799 < 1073741800f));
let _e22808 = select(0i, select(select(i32(_e22801), i32(-2147483648), (_e22801 < -2147483600f)), 2147483647i, (_e22801 > 2147483500f)), (_e22801 == _e22801));
let _e22812 = (_e22808 - select(0i, 1i, (_e22801 < f32(_e22808))));
let _e22813 = select(0i, 20i, _e22793);
let _e22817 = (bitcast<u32>(_e22812) << bitcast<u32>((_e22813 & 31i)));
let _e22824 = bitcast<u32>(((_e22812 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22813) & 31i))));
let _e22828 = (bitcast<f32>((bitcast<u32>(_e22788) & 2147483647u)) >= 1073741800f);
let _e22831 = ((_e22788 * select(1f, _e22794, _e22828)) + 0.5f);
let _e22833 = select(-1073741800f, _e22831, (_e22831 > -1073741800f));
let _e22835 = select(1073741800f, _e22833, (_e22833 < 1073741800f));
let _e22842 = select(0i, select(select(i32(_e22835), i32(-2147483648), (_e22835 < -2147483600f)), 2147483647i, (_e22835 > 2147483500f)), (_e22835 == _e22835));
let _e22846 = (_e22842 - select(0i, 1i, (_e22835 < f32(_e22842))));
let _e22847 = select(0i, 20i, _e22828);
let _e22851 = (bitcast<u32>(_e22846) << bitcast<u32>((_e22847 & 31i)));
let _e22858 = bitcast<u32>(((_e22846 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22847) & 31i))));
let _e22862 = (bitcast<f32>((bitcast<u32>(_e22789) & 2147483647u)) >= 1073741800f);
let _e22865 = ((_e22789 * select(1f, _e22794, _e22862)) + 0.5f);
let _e22867 = select(-1073741800f, _e22865, (_e22865 > -1073741800f));
let _e22869 = select(1073741800f, _e22867, (_e22867 < 1073741800f));
let _e22876 = select(0i, select(select(i32(_e22869), i32(-2147483648), (_e22869 < -2147483600f)), 2147483647i, (_e22869 > 2147483500f)), (_e22869 == _e22869));
let _e22880 = (_e22876 - select(0i, 1i, (_e22869 < f32(_e22876))));
let _e22881 = select(0i, 20i, _e22862);
let _e22885 = (bitcast<u32>(_e22880) << bitcast<u32>((_e22881 & 31i)));
let _e22892 = bitcast<u32>(((_e22880 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22881) & 31i))));
let _e22897 = bitcast<i32>(bitcast<u32>((((_e22776.member_1 * _e14761) + _e22776.member) * 6i)));
if ((_e22817 | _e22824) == 0u) {
} else {
let _e22900 = bitcast<u32>(_e22897);
if (_e22900 < _e270) {
let _e22904 = atomicAdd((&global_8.member[_e22900]), _e22817);
phi_64103_ = _e22904;
} else {
phi_64103_ = 0u;
}
let _e22906 = phi_64103_;
let _e22910 = (_e22824 + select(0u, 1u, ((_e22906 + _e22817) < _e22817)));
if (_e22910 == 0u) {
} else {
let _e22912 = (_e22900 + 1u);
if (_e22912 < _e270) {
let _e22916 = atomicAdd((&global_8.member[_e22912]), _e22910);
}
}
}
if ((_e22851 | _e22858) == 0u) {
} else {
let _e22920 = bitcast<u32>((_e22897 + 2i));
if (_e22920 < _e270) {
let _e22924 = atomicAdd((&global_8.member[_e22920]), _e22851);
phi_64133_ = _e22924;
} else {
phi_64133_ = 0u;
}
let _e22926 = phi_64133_;
let _e22930 = (_e22858 + select(0u, 1u, ((_e22926 + _e22851) < _e22851)));
if (_e22930 == 0u) {
} else {
let _e22932 = (_e22920 + 1u);
if (_e22932 < _e270) {
let _e22936 = atomicAdd((&global_8.member[_e22932]), _e22930);
}
}
}
if ((_e22885 | _e22892) == 0u) {
} else {
let _e22940 = bitcast<u32>((_e22897 + 4i));
if (_e22940 < _e270) {
let _e22944 = atomicAdd((&global_8.member[_e22940]), _e22885);
phi_64163_ = _e22944;
} else {
phi_64163_ = 0u;
}
let _e22946 = phi_64163_;
let _e22950 = (_e22892 + select(0u, 1u, ((_e22946 + _e22885) < _e22885)));
if (_e22950 == 0u) {
} else {
let _e22952 = (_e22940 + 1u);
if (_e22952 < _e270) {
let _e22956 = atomicAdd((&global_8.member[_e22952]), _e22950);
}
}
}
phi_59977_ = (_e21615 + 1i);
} else {
phi_59977_ = i32();
}
let _e22959 = phi_59977_;
continue;
continuing {
phi_59976_ = _e22959;
break if !(_e21618);
}
}
phi_59823_ = (_e21521 + 1i);
} else {
phi_59823_ = i32();
}
let _e22963 = phi_59823_;
continue;
continuing {
phi_59822_ = _e22963;
break if !(_e21522);
}
}
} else {
phi_64208_ = 0i;
loop {
let _e22966 = phi_64208_;
let _e22967 = (_e22966 < 16i);
if _e22967 {
let _e22969 = (_e14806 + (_e22966 & 15i));
let _e22971 = (f32(_e22969) + 0.5f);
let _e22973 = ((_e22971 * 1f) - 0.5f);
let _e22977 = (-(((_e416 * _e22973) + _e442)) / _e429);
let _e22984 = bitcast<f32>((bitcast<u32>(((_e466 * _e22973) + ((_e479 * _e22977) + _e492))) & 2147483647u));
let _e22991 = bitcast<f32>((bitcast<u32>(((_e505 * _e22973) + ((_e518 * _e22977) + _e531))) & 2147483647u));
let _e22995 = (((0.5f * (_e22984 + _e22991)) / _e534) + _e717);
let _e22996 = (1f / 1f);
let _e23004 = ((((_e22977 + _e22995) + 0.5f) * _e22996) - 0.5f);
let _e23005 = f32(_e20750);
let _e23006 = f32(_e20748);
let _e23007 = (_e23005 - 1f);
let _e23009 = select(_e23007, _e23004, (_e23004 > _e23007));
let _e23011 = select(_e23006, _e23009, (_e23009 < _e23006));
let _e23018 = select(0i, select(select(i32(_e23011), i32(-2147483648), (_e23011 < -2147483600f)), 2147483647i, (_e23011 > 2147483500f)), (_e23011 == _e23011));
let _e23023 = (((((_e22977 - _e22995) + 0.5f) * _e22996) - 0.5f) + 1f);
let _e23024 = (_e23006 + 1f);
let _e23026 = select(_e23005, _e23023, (_e23023 > _e23005));
let _e23028 = select(_e23024, _e23026, (_e23026 < _e23024));
let _e23035 = select(0i, select(select(i32(_e23028), i32(-2147483648), (_e23028 < -2147483600f)), 2147483647i, (_e23028 > 2147483500f)), (_e23028 == _e23028));
let _e23046 = ((1e-4f * 1f) * _e534);
let _e23048 = select(_e22991, _e22984, (_e22984 > _e22991));
let _e23050 = select(_e23046, _e23048, (_e23048 > _e23046));
let _e23052 = select(_e22991, _e22984, (_e22984 < _e22991));
let _e23054 = select(_e23046, _e23052, (_e23052 > _e23046));
let _e23056 = (0.5f * (_e23050 + _e23054));
let _e23057 = (0.5f / _e23054);
let _e23058 = (1f / _e23050);
phi_64362_ = 0i;
loop {
let _e23060 = phi_64362_;
let _e23062 = (((_e23035 - select(0i, 1i, (_e23028 < f32(_e23035)))) + (_e22966 >> bitcast<u32>(4u))) + bitcast<i32>(_e23060));
let _e23063 = (_e23062 <= select(-1i, (_e23018 - select(0i, 1i, (_e23011 < f32(_e23018)))), (_e22969 <= _e14810)));
if _e23063 {
let _e23065 = (f32(_e23062) + 0.5f);
let _e23069 = ((((_e23065 * 1f) - 0.5f) - _e22977) * _e534);
let _e23070 = (_e534 * 1f);
let _e23072 = (0.5f * _e23070);
let _e23073 = (_e23069 + _e23072);
let _e23074 = -(_e23073);
let _e23077 = (_e23056 - select(_e23074, _e23073, (_e23073 > _e23074)));
let _e23079 = select(0f, _e23077, (_e23077 > 0f));
let _e23081 = select(_e23054, _e23079, (_e23079 < _e23054));
let _e23084 = (_e23077 - _e23054);
let _e23088 = (((_e23081 * (_e23081 * _e23057)) + select(0f, _e23084, (_e23084 > 0f))) * _e23058);
let _e23092 = (_e23069 - _e23072);
let _e23093 = -(_e23092);
let _e23096 = (_e23056 - select(_e23093, _e23092, (_e23092 > _e23093)));
let _e23098 = select(0f, _e23096, (_e23096 > 0f));
let _e23100 = select(_e23054, _e23098, (_e23098 < _e23054));
let _e23103 = (_e23096 - _e23054);
let _e23107 = (((_e23100 * (_e23100 * _e23057)) + select(0f, _e23103, (_e23103 > 0f))) * _e23058);
if _e453 {
phi_64467_ = type_23(_e23062, _e22969);
} else {
phi_64467_ = type_23(_e22969, _e23062);
}
let _e23116 = phi_64467_;
local_24 = bitcast<i32>((_e14757 * _e14760));
local_25 = ((_e23116.member_1 * _e14761) + _e23116.member);
let _e23123 = local_24;
let _e23124 = local_25;
let _e23125 = (_e23123 + _e23124);
let _e23127 = (bitcast<i32>(_e259) - 1i);
let _e23129 = select(_e23127, _e23125, (_e23125 < _e23127));
let _e23134 = global_5.member[bitcast<u32>(select(0i, _e23129, (_e23129 > 0i)))];
let _e23135 = local_25;
let _e23137 = select(_e23127, _e23135, (_e23135 < _e23127));
let _e23142 = global_5.member[bitcast<u32>(select(0i, _e23137, (_e23137 > 0i)))];
let _e23145 = f32(_e14761);
let _e23146 = f32(_e14762);
let _e23153 = global_1.member.member_2.member;
let _e23154 = (((((f32(_e23116.member) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e23161 = global_1.member.member_2.member_1;
let _e23162 = ((1f - (((f32(_e23116.member_1) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e23164 = global_1.member.member_3;
let _e23172 = global_1.member.member_4;
let _e23179 = ((_e23164.member * _e23154) + (_e23172.member * _e23162));
let _e23180 = ((_e23164.member_1 * _e23154) + (_e23172.member_1 * _e23162));
let _e23181 = ((_e23164.member_2 * _e23154) + (_e23172.member_2 * _e23162));
let _e23184 = global_1.member.member_2.member_3;
let _e23185 = (_e23184 != 0u);
let _e23187 = global_1.member.member_5;
let _e23194 = select((_e23187.member + _e23179), _e23187.member, _e23185);
let _e23195 = select((_e23187.member_1 + _e23180), _e23187.member_1, _e23185);
let _e23196 = select((_e23187.member_2 + _e23181), _e23187.member_2, _e23185);
let _e23198 = global_1.member.member_6;
let _e23212 = (((_e23194 * _e23194) + (_e23195 * _e23195)) + (_e23196 * _e23196));
let _e23215 = sqrt(select(0f, _e23212, (_e23212 > 0f)));
let _e23216 = (1f / _e23215);
let _e23217 = (_e23194 * _e23216);
let _e23218 = (_e23195 * _e23216);
let _e23219 = (_e23196 * _e23216);
let _e23220 = (_e575 - select(_e23198.member, (_e23198.member + _e23179), _e23185));
let _e23221 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e23180), _e23185));
let _e23222 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e23181), _e23185));
let _e23227 = (((_e23220 * _e23217) + (_e23221 * _e23218)) + (_e23222 * _e23219));
let _e23232 = (((_e23220 * _e613) + (_e23221 * _e626)) + (_e23222 * _e639));
let _e23237 = (((_e23217 * _e613) + (_e23218 * _e626)) + (_e23219 * _e639));
let _e23240 = ((_e23218 * _e639) - (_e23219 * _e626));
let _e23243 = ((_e23219 * _e613) - (_e23217 * _e639));
let _e23246 = ((_e23217 * _e626) - (_e23218 * _e613));
let _e23251 = (((_e23240 * _e23240) + (_e23243 * _e23243)) + (_e23246 * _e23246));
let _e23254 = (1f / select(1e-9f, _e23251, (_e23251 > 1e-9f)));
let _e23257 = ((_e23227 - (_e23237 * _e23232)) * _e23254);
let _e23260 = (((_e23237 * _e23227) - _e23232) * _e23254);
let _e23266 = -(_e23237);
let _e23269 = global_1.member.member_13.member_2;
let _e23270 = (_e23269 * _e23269);
let _e23274 = ((1f + _e23270) - ((2f * _e23269) * _e23266));
let _e23276 = select(1e-9f, _e23274, (_e23274 > 1e-9f));
let _e23288 = global_1.member.member_13.member_3;
if (_e23288 == 2u) {
let _e23293 = (0.5f - (0.5f * _e23266));
let _e23295 = select(0f, _e23293, (_e23293 > 0f));
let _e23299 = (sqrt(select(0f, _e23295, (_e23295 > 0f))) * 255f);
let _e23300 = (255f - 1f);
let _e23302 = select(0f, _e23299, (_e23299 > 0f));
let _e23304 = select(_e23300, _e23302, (_e23302 < _e23300));
let _e23311 = select(0i, select(select(i32(_e23304), i32(-2147483648), (_e23304 < -2147483600f)), 2147483647i, (_e23304 > 2147483500f)), (_e23304 == _e23304));
let _e23315 = (_e23311 - select(0i, 1i, (_e23304 < f32(_e23311))));
let _e23318 = global_1.member.member_13.member_11;
let _e23319 = bitcast<i32>(_e23318);
let _e23320 = (_e23319 + _e23315);
let _e23322 = (bitcast<i32>(_e265) - 1i);
let _e23324 = select(_e23322, _e23320, (_e23320 < _e23322));
let _e23329 = global_2.member[bitcast<u32>(select(0i, _e23324, (_e23324 > 0i)))];
let _e23331 = (_e23319 + (_e23315 + 1i));
let _e23333 = select(_e23322, _e23331, (_e23331 < _e23322));
let _e23338 = global_2.member[bitcast<u32>(select(0i, _e23333, (_e23333 > 0i)))];
phi_64894_ = (_e23329 + ((_e23338 - _e23329) * (_e23299 - f32(_e23315))));
} else {
phi_64894_ = select(((1f - _e23270) / (_e23276 * sqrt(select(0f, _e23276, (_e23276 > 0f))))), (0.75f * (1f + (_e23266 * _e23266))), (_e23288 == 1u));
}
let _e23345 = phi_64894_;
let _e23348 = (_e23215 * (_e23345 * (0.25f / 3.1415927f)));
let _e23349 = (_e23257 - _e23134);
let _e23352 = (_e23260 + select(0f, _e23349, (_e23349 > 0f)));
let _e23355 = global_1.member.member_13.member_1;
let _e23364 = global_1.member.member_13.member;
let _e23369 = -((_e23364.member * _e23352));
let _e23371 = select(-87f, _e23369, (_e23369 > -87f));
let _e23373 = select(88f, _e23371, (_e23371 < 88f));
let _e23375 = ((_e23373 * 1.442695f) + 0.5f);
let _e23377 = select(-127f, _e23375, (_e23375 > -127f));
let _e23379 = select(128f, _e23377, (_e23377 < 128f));
let _e23386 = select(0i, select(select(i32(_e23379), i32(-2147483648), (_e23379 < -2147483600f)), 2147483647i, (_e23379 > 2147483500f)), (_e23379 == _e23379));
let _e23390 = (_e23386 - select(0i, 1i, (_e23379 < f32(_e23386))));
let _e23391 = f32(_e23390);
let _e23395 = ((_e23373 - (_e23391 * 0.6933594f)) - (_e23391 * -2.1219444e-4f));
let _e23417 = -((_e23364.member_1 * _e23352));
let _e23419 = select(-87f, _e23417, (_e23417 > -87f));
let _e23421 = select(88f, _e23419, (_e23419 < 88f));
let _e23423 = ((_e23421 * 1.442695f) + 0.5f);
let _e23425 = select(-127f, _e23423, (_e23423 > -127f));
let _e23427 = select(128f, _e23425, (_e23425 < 128f));
let _e23434 = select(0i, select(select(i32(_e23427), i32(-2147483648), (_e23427 < -2147483600f)), 2147483647i, (_e23427 > 2147483500f)), (_e23427 == _e23427));
let _e23438 = (_e23434 - select(0i, 1i, (_e23427 < f32(_e23434))));
let _e23439 = f32(_e23438);
let _e23443 = ((_e23421 - (_e23439 * 0.6933594f)) - (_e23439 * -2.1219444e-4f));
let _e23465 = -((_e23364.member_2 * _e23352));
let _e23467 = select(-87f, _e23465, (_e23465 > -87f));
let _e23469 = select(88f, _e23467, (_e23467 < 88f));
let _e23471 = ((_e23469 * 1.442695f) + 0.5f);
let _e23473 = select(-127f, _e23471, (_e23471 > -127f));
let _e23475 = select(128f, _e23473, (_e23473 < 128f));
let _e23482 = select(0i, select(select(i32(_e23475), i32(-2147483648), (_e23475 < -2147483600f)), 2147483647i, (_e23475 > 2147483500f)), (_e23475 == _e23475));
let _e23486 = (_e23482 - select(0i, 1i, (_e23475 < f32(_e23482))));
let _e23487 = f32(_e23486);
let _e23491 = ((_e23469 - (_e23487 * 0.6933594f)) - (_e23487 * -2.1219444e-4f));
let _e23518 = select(0f, _e23257, (((_e23260 >= 0f) && (_e23260 < _e691)) && (_e23257 > 0f)));
if _e453 {
phi_65163_ = type_23(_e19820, _e19819);
} else {
phi_65163_ = type_23(_e19819, _e19820);
}
let _e23522 = phi_65163_;
let _e23527 = f32((1i << bitcast<u32>(_e19808)));
let _e23528 = (1f / _e23527);
let _e23530 = ((_e22971 * _e23528) - 0.5f);
let _e23532 = ((_e23065 * _e23528) - 0.5f);
let _e23534 = select(-1f, _e23530, (_e23530 > -1f));
let _e23536 = select(1e6f, _e23534, (_e23534 < 1e6f));
let _e23543 = select(0i, select(select(i32(_e23536), i32(-2147483648), (_e23536 < -2147483600f)), 2147483647i, (_e23536 > 2147483500f)), (_e23536 == _e23536));
let _e23547 = (_e23543 - select(0i, 1i, (_e23536 < f32(_e23543))));
let _e23549 = select(-1f, _e23532, (_e23532 > -1f));
let _e23551 = select(1e6f, _e23549, (_e23549 < 1e6f));
let _e23558 = select(0i, select(select(i32(_e23551), i32(-2147483648), (_e23551 < -2147483600f)), 2147483647i, (_e23551 > 2147483500f)), (_e23551 == _e23551));
let _e23562 = (_e23558 - select(0i, 1i, (_e23551 < f32(_e23558))));
let _e23564 = (_e23530 - f32(_e23547));
let _e23566 = (_e23532 - f32(_e23562));
let _e23567 = (1f - _e23564);
let _e23568 = (1f - _e23566);
let _e23571 = select(_e23547, 0i, (_e23547 < 0i));
let _e23572 = (_e23571 >= _e23522.member);
if _e23572 {
phi_65241_ = (_e23522.member - 1i);
} else {
phi_65241_ = _e23571;
}
let _e23575 = phi_65241_;
let _e23577 = select(_e23562, 0i, (_e23562 < 0i));
let _e23578 = (_e23577 >= _e23522.member_1);
if _e23578 {
phi_65252_ = (_e23522.member_1 - 1i);
} else {
phi_65252_ = _e23577;
}
let _e23581 = phi_65252_;
let _e23585 = (((f32(_e23575) + 0.5f) * _e23527) - 0.5f);
let _e23589 = (((f32(_e23581) + 0.5f) * _e23527) - 0.5f);
if _e453 {
phi_65280_ = type_23(_e23581, _e23575);
} else {
phi_65280_ = type_23(_e23575, _e23581);
}
let _e23595 = phi_65280_;
let _e23601 = bitcast<i32>(((_e14757 + 1u) >> bitcast<u32>(1u)));
let _e23604 = global_1.member.member_18.member_6;
let _e23607 = global_1.member.member_18.member_7;
let _e23610 = global_1.member.member_18.member_8;
if _e14812 {
phi_65331_ = 0u;
} else {
if (_e766 == 1u) {
phi_65330_ = 0u;
} else {
if (_e766 == 2u) {
phi_65329_ = _e23604;
} else {
phi_65329_ = select(_e23610, _e23607, (_e766 == 3u));
}
let _e23616 = phi_65329_;
phi_65330_ = _e23616;
}
let _e23618 = phi_65330_;
phi_65331_ = _e23618;
}
let _e23620 = phi_65331_;
local_22 = (((bitcast<i32>(_e23620) + _e23595.member_1) * _e23601) + _e23595.member);
let _e23625 = local_22;
let _e23627 = (bitcast<i32>(_e262) - 1i);
let _e23629 = select(_e23627, _e23625, (_e23625 < _e23627));
let _e23634 = global_6.member[bitcast<u32>(select(0i, _e23629, (_e23629 > 0i)))];
let _e23639 = (((((select(_e23585, _e23589, _e453) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e23644 = ((1f - (((select(_e23589, _e23585, _e453) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e23651 = ((_e23164.member * _e23639) + (_e23172.member * _e23644));
let _e23652 = ((_e23164.member_1 * _e23639) + (_e23172.member_1 * _e23644));
let _e23653 = ((_e23164.member_2 * _e23639) + (_e23172.member_2 * _e23644));
let _e23657 = select((_e23187.member + _e23651), _e23187.member, _e23185);
let _e23658 = select((_e23187.member_1 + _e23652), _e23187.member_1, _e23185);
let _e23659 = select((_e23187.member_2 + _e23653), _e23187.member_2, _e23185);
let _e23670 = (((_e23657 * _e23657) + (_e23658 * _e23658)) + (_e23659 * _e23659));
let _e23674 = (1f / sqrt(select(0f, _e23670, (_e23670 > 0f))));
let _e23675 = (_e23657 * _e23674);
let _e23676 = (_e23658 * _e23674);
let _e23677 = (_e23659 * _e23674);
let _e23678 = (_e575 - select(_e23198.member, (_e23198.member + _e23651), _e23185));
let _e23679 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e23652), _e23185));
let _e23680 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e23653), _e23185));
let _e23685 = (((_e23678 * _e23675) + (_e23679 * _e23676)) + (_e23680 * _e23677));
let _e23690 = (((_e23678 * _e613) + (_e23679 * _e626)) + (_e23680 * _e639));
let _e23695 = (((_e23675 * _e613) + (_e23676 * _e626)) + (_e23677 * _e639));
let _e23698 = ((_e23676 * _e639) - (_e23677 * _e626));
let _e23701 = ((_e23677 * _e613) - (_e23675 * _e639));
let _e23704 = ((_e23675 * _e626) - (_e23676 * _e613));
let _e23709 = (((_e23698 * _e23698) + (_e23701 * _e23701)) + (_e23704 * _e23704));
let _e23712 = (1f / select(1e-9f, _e23709, (_e23709 > 1e-9f)));
let _e23715 = ((_e23685 - (_e23695 * _e23690)) * _e23712);
let _e23718 = (((_e23695 * _e23685) - _e23690) * _e23712);
let _e23724 = select(0f, _e23715, (((_e23718 >= 0f) && (_e23718 < _e691)) && (_e23715 > 0f)));
let _e23726 = (_e23575 << bitcast<u32>(_e19808));
let _e23738 = (_e23547 + 1i);
let _e23741 = select(_e23738, 0i, (_e23738 < 0i));
let _e23742 = (_e23741 >= _e23522.member);
if _e23742 {
phi_65992_ = (_e23522.member - 1i);
} else {
phi_65992_ = _e23741;
}
let _e23745 = phi_65992_;
if _e23578 {
phi_66003_ = (_e23522.member_1 - 1i);
} else {
phi_66003_ = _e23577;
}
let _e23748 = phi_66003_;
let _e23752 = (((f32(_e23745) + 0.5f) * _e23527) - 0.5f);
let _e23756 = (((f32(_e23748) + 0.5f) * _e23527) - 0.5f);
if _e453 {
phi_66031_ = type_23(_e23748, _e23745);
} else {
phi_66031_ = type_23(_e23745, _e23748);
}
let _e23762 = phi_66031_;
if _e14812 {
phi_66082_ = 0u;
} else {
if (_e766 == 1u) {
phi_66081_ = 0u;
} else {
if (_e766 == 2u) {
phi_66080_ = _e23604;
} else {
phi_66080_ = select(_e23610, _e23607, (_e766 == 3u));
}
let _e23770 = phi_66080_;
phi_66081_ = _e23770;
}
let _e23772 = phi_66081_;
phi_66082_ = _e23772;
}
let _e23774 = phi_66082_;
local_20 = (((bitcast<i32>(_e23774) + _e23762.member_1) * _e23601) + _e23762.member);
let _e23779 = local_20;
let _e23781 = select(_e23627, _e23779, (_e23779 < _e23627));
let _e23786 = global_6.member[bitcast<u32>(select(0i, _e23781, (_e23781 > 0i)))];
let _e23791 = (((((select(_e23752, _e23756, _e453) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e23796 = ((1f - (((select(_e23756, _e23752, _e453) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e23803 = ((_e23164.member * _e23791) + (_e23172.member * _e23796));
let _e23804 = ((_e23164.member_1 * _e23791) + (_e23172.member_1 * _e23796));
let _e23805 = ((_e23164.member_2 * _e23791) + (_e23172.member_2 * _e23796));
let _e23809 = select((_e23187.member + _e23803), _e23187.member, _e23185);
let _e23810 = select((_e23187.member_1 + _e23804), _e23187.member_1, _e23185);
let _e23811 = select((_e23187.member_2 + _e23805), _e23187.member_2, _e23185);
let _e23822 = (((_e23809 * _e23809) + (_e23810 * _e23810)) + (_e23811 * _e23811));
let _e23826 = (1f / sqrt(select(0f, _e23822, (_e23822 > 0f))));
let _e23827 = (_e23809 * _e23826);
let _e23828 = (_e23810 * _e23826);
let _e23829 = (_e23811 * _e23826);
let _e23830 = (_e575 - select(_e23198.member, (_e23198.member + _e23803), _e23185));
let _e23831 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e23804), _e23185));
let _e23832 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e23805), _e23185));
let _e23837 = (((_e23830 * _e23827) + (_e23831 * _e23828)) + (_e23832 * _e23829));
let _e23842 = (((_e23830 * _e613) + (_e23831 * _e626)) + (_e23832 * _e639));
let _e23847 = (((_e23827 * _e613) + (_e23828 * _e626)) + (_e23829 * _e639));
let _e23850 = ((_e23828 * _e639) - (_e23829 * _e626));
let _e23853 = ((_e23829 * _e613) - (_e23827 * _e639));
let _e23856 = ((_e23827 * _e626) - (_e23828 * _e613));
let _e23861 = (((_e23850 * _e23850) + (_e23853 * _e23853)) + (_e23856 * _e23856));
let _e23864 = (1f / select(1e-9f, _e23861, (_e23861 > 1e-9f)));
let _e23867 = ((_e23837 - (_e23847 * _e23842)) * _e23864);
let _e23870 = (((_e23847 * _e23837) - _e23842) * _e23864);
let _e23876 = select(0f, _e23867, (((_e23870 >= 0f) && (_e23870 < _e691)) && (_e23867 > 0f)));
let _e23878 = (_e23745 << bitcast<u32>(_e19808));
let _e23890 = (_e23562 + 1i);
if _e23572 {
phi_66743_ = (_e23522.member - 1i);
} else {
phi_66743_ = _e23571;
}
let _e23894 = phi_66743_;
let _e23896 = select(_e23890, 0i, (_e23890 < 0i));
let _e23897 = (_e23896 >= _e23522.member_1);
if _e23897 {
phi_66754_ = (_e23522.member_1 - 1i);
} else {
phi_66754_ = _e23896;
}
let _e23900 = phi_66754_;
let _e23904 = (((f32(_e23894) + 0.5f) * _e23527) - 0.5f);
let _e23908 = (((f32(_e23900) + 0.5f) * _e23527) - 0.5f);
if _e453 {
phi_66782_ = type_23(_e23900, _e23894);
} else {
phi_66782_ = type_23(_e23894, _e23900);
}
let _e23914 = phi_66782_;
if _e14812 {
phi_66833_ = 0u;
} else {
if (_e766 == 1u) {
phi_66832_ = 0u;
} else {
if (_e766 == 2u) {
phi_66831_ = _e23604;
} else {
phi_66831_ = select(_e23610, _e23607, (_e766 == 3u));
}
let _e23922 = phi_66831_;
phi_66832_ = _e23922;
}
let _e23924 = phi_66832_;
phi_66833_ = _e23924;
}
let _e23926 = phi_66833_;
local_18 = (((bitcast<i32>(_e23926) + _e23914.member_1) * _e23601) + _e23914.member);
let _e23931 = local_18;
let _e23933 = select(_e23627, _e23931, (_e23931 < _e23627));
let _e23938 = global_6.member[bitcast<u32>(select(0i, _e23933, (_e23933 > 0i)))];
let _e23943 = (((((select(_e23904, _e23908, _e453) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e23948 = ((1f - (((select(_e23908, _e23904, _e453) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e23955 = ((_e23164.member * _e23943) + (_e23172.member * _e23948));
let _e23956 = ((_e23164.member_1 * _e23943) + (_e23172.member_1 * _e23948));
let _e23957 = ((_e23164.member_2 * _e23943) + (_e23172.member_2 * _e23948));
let _e23961 = select((_e23187.member + _e23955), _e23187.member, _e23185);
let _e23962 = select((_e23187.member_1 + _e23956), _e23187.member_1, _e23185);
let _e23963 = select((_e23187.member_2 + _e23957), _e23187.member_2, _e23185);
let _e23974 = (((_e23961 * _e23961) + (_e23962 * _e23962)) + (_e23963 * _e23963));
let _e23978 = (1f / sqrt(select(0f, _e23974, (_e23974 > 0f))));
let _e23979 = (_e23961 * _e23978);
let _e23980 = (_e23962 * _e23978);
let _e23981 = (_e23963 * _e23978);
let _e23982 = (_e575 - select(_e23198.member, (_e23198.member + _e23955), _e23185));
let _e23983 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e23956), _e23185));
let _e23984 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e23957), _e23185));
let _e23989 = (((_e23982 * _e23979) + (_e23983 * _e23980)) + (_e23984 * _e23981));
let _e23994 = (((_e23982 * _e613) + (_e23983 * _e626)) + (_e23984 * _e639));
let _e23999 = (((_e23979 * _e613) + (_e23980 * _e626)) + (_e23981 * _e639));
let _e24002 = ((_e23980 * _e639) - (_e23981 * _e626));
let _e24005 = ((_e23981 * _e613) - (_e23979 * _e639));
let _e24008 = ((_e23979 * _e626) - (_e23980 * _e613));
let _e24013 = (((_e24002 * _e24002) + (_e24005 * _e24005)) + (_e24008 * _e24008));
let _e24016 = (1f / select(1e-9f, _e24013, (_e24013 > 1e-9f)));
let _e24019 = ((_e23989 - (_e23999 * _e23994)) * _e24016);
let _e24022 = (((_e23999 * _e23989) - _e23994) * _e24016);
let _e24028 = select(0f, _e24019, (((_e24022 >= 0f) && (_e24022 < _e691)) && (_e24019 > 0f)));
let _e24030 = (_e23894 << bitcast<u32>(_e19808));
if _e23742 {
phi_67494_ = (_e23522.member - 1i);
} else {
phi_67494_ = _e23741;
}
let _e24045 = phi_67494_;
if _e23897 {
phi_67505_ = (_e23522.member_1 - 1i);
} else {
phi_67505_ = _e23896;
}
let _e24048 = phi_67505_;
let _e24052 = (((f32(_e24045) + 0.5f) * _e23527) - 0.5f);
let _e24056 = (((f32(_e24048) + 0.5f) * _e23527) - 0.5f);
if _e453 {
phi_67533_ = type_23(_e24048, _e24045);
} else {
phi_67533_ = type_23(_e24045, _e24048);
}
let _e24062 = phi_67533_;
if _e14812 {
phi_67584_ = 0u;
} else {
if (_e766 == 1u) {
phi_67583_ = 0u;
} else {
if (_e766 == 2u) {
phi_67582_ = _e23604;
} else {
phi_67582_ = select(_e23610, _e23607, (_e766 == 3u));
}
let _e24070 = phi_67582_;
phi_67583_ = _e24070;
}
let _e24072 = phi_67583_;
phi_67584_ = _e24072;
}
let _e24074 = phi_67584_;
local_16 = (((bitcast<i32>(_e24074) + _e24062.member_1) * _e23601) + _e24062.member);
let _e24079 = local_16;
let _e24081 = select(_e23627, _e24079, (_e24079 < _e23627));
let _e24086 = global_6.member[bitcast<u32>(select(0i, _e24081, (_e24081 > 0i)))];
let _e24091 = (((((select(_e24052, _e24056, _e453) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e24096 = ((1f - (((select(_e24056, _e24052, _e453) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e24103 = ((_e23164.member * _e24091) + (_e23172.member * _e24096));
let _e24104 = ((_e23164.member_1 * _e24091) + (_e23172.member_1 * _e24096));
let _e24105 = ((_e23164.member_2 * _e24091) + (_e23172.member_2 * _e24096));
let _e24109 = select((_e23187.member + _e24103), _e23187.member, _e23185);
let _e24110 = select((_e23187.member_1 + _e24104), _e23187.member_1, _e23185);
let _e24111 = select((_e23187.member_2 + _e24105), _e23187.member_2, _e23185);
let _e24122 = (((_e24109 * _e24109) + (_e24110 * _e24110)) + (_e24111 * _e24111));
let _e24126 = (1f / sqrt(select(0f, _e24122, (_e24122 > 0f))));
let _e24127 = (_e24109 * _e24126);
let _e24128 = (_e24110 * _e24126);
let _e24129 = (_e24111 * _e24126);
let _e24130 = (_e575 - select(_e23198.member, (_e23198.member + _e24103), _e23185));
let _e24131 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e24104), _e23185));
let _e24132 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e24105), _e23185));
let _e24137 = (((_e24130 * _e24127) + (_e24131 * _e24128)) + (_e24132 * _e24129));
let _e24142 = (((_e24130 * _e613) + (_e24131 * _e626)) + (_e24132 * _e639));
let _e24147 = (((_e24127 * _e613) + (_e24128 * _e626)) + (_e24129 * _e639));
let _e24150 = ((_e24128 * _e639) - (_e24129 * _e626));
let _e24153 = ((_e24129 * _e613) - (_e24127 * _e639));
let _e24156 = ((_e24127 * _e626) - (_e24128 * _e613));
let _e24161 = (((_e24150 * _e24150) + (_e24153 * _e24153)) + (_e24156 * _e24156));
let _e24164 = (1f / select(1e-9f, _e24161, (_e24161 > 1e-9f)));
let _e24167 = ((_e24137 - (_e24147 * _e24142)) * _e24164);
let _e24170 = (((_e24147 * _e24137) - _e24142) * _e24164);
let _e24176 = select(0f, _e24167, (((_e24170 >= 0f) && (_e24170 < _e691)) && (_e24167 > 0f)));
let _e24178 = (_e24045 << bitcast<u32>(_e19808));
let _e24190 = select(((((1f - select(0f, (_e23567 * _e23568), (((select(select(_e766, _e923, (_e23726 >= _e692)), _e845, (_e23726 < _e298)) == _e766) && (_e23724 > 0f)) && (_e23724 < _e23634)))) - select(0f, (_e23564 * _e23568), (((select(select(_e766, _e923, (_e23878 >= _e692)), _e845, (_e23878 < _e298)) == _e766) && (_e23876 > 0f)) && (_e23876 < _e23786)))) - select(0f, (_e23567 * _e23566), (((select(select(_e766, _e923, (_e24030 >= _e692)), _e845, (_e24030 < _e298)) == _e766) && (_e24028 > 0f)) && (_e24028 < _e23938)))) - select(0f, (_e23564 * _e23566), (((select(select(_e766, _e923, (_e24178 >= _e692)), _e845, (_e24178 < _e298)) == _e766) && (_e24176 > 0f)) && (_e24176 < _e24086)))), 1f, _e14812);
let _e24191 = (_e20752 & 31u);
let _e24193 = (1u << bitcast<u32>(_e24191));
let _e24202 = bitcast<i32>((((_e14757 + _e24193) - 1u) >> bitcast<u32>(_e24191)));
let _e24203 = bitcast<i32>((((_e14760 + _e24193) - 1u) >> bitcast<u32>(_e24191)));
if _e453 {
phi_68263_ = type_23(_e24203, _e24202);
} else {
phi_68263_ = type_23(_e24202, _e24203);
}
let _e24207 = phi_68263_;
let _e24212 = f32((1i << bitcast<u32>(_e24191)));
let _e24213 = (1f / _e24212);
let _e24215 = ((_e22971 * _e24213) - 0.5f);
let _e24217 = ((_e23065 * _e24213) - 0.5f);
let _e24219 = select(-1f, _e24215, (_e24215 > -1f));
let _e24221 = select(1e6f, _e24219, (_e24219 < 1e6f));
let _e24228 = select(0i, select(select(i32(_e24221), i32(-2147483648), (_e24221 < -2147483600f)), 2147483647i, (_e24221 > 2147483500f)), (_e24221 == _e24221));
let _e24232 = (_e24228 - select(0i, 1i, (_e24221 < f32(_e24228))));
let _e24234 = select(-1f, _e24217, (_e24217 > -1f));
let _e24236 = select(1e6f, _e24234, (_e24234 < 1e6f));
let _e24243 = select(0i, select(select(i32(_e24236), i32(-2147483648), (_e24236 < -2147483600f)), 2147483647i, (_e24236 > 2147483500f)), (_e24236 == _e24236));
let _e24247 = (_e24243 - select(0i, 1i, (_e24236 < f32(_e24243))));
let _e24249 = (_e24215 - f32(_e24232));
let _e24251 = (_e24217 - f32(_e24247));
let _e24252 = (1f - _e24249);
let _e24253 = (1f - _e24251);
let _e24256 = select(_e24232, 0i, (_e24232 < 0i));
let _e24257 = (_e24256 >= _e24207.member);
if _e24257 {
phi_68341_ = (_e24207.member - 1i);
} else {
phi_68341_ = _e24256;
}
let _e24260 = phi_68341_;
let _e24262 = select(_e24247, 0i, (_e24247 < 0i));
let _e24263 = (_e24262 >= _e24207.member_1);
if _e24263 {
phi_68352_ = (_e24207.member_1 - 1i);
} else {
phi_68352_ = _e24262;
}
let _e24266 = phi_68352_;
let _e24270 = (((f32(_e24260) + 0.5f) * _e24212) - 0.5f);
let _e24274 = (((f32(_e24266) + 0.5f) * _e24212) - 0.5f);
if _e453 {
phi_68380_ = type_23(_e24266, _e24260);
} else {
phi_68380_ = type_23(_e24260, _e24266);
}
let _e24280 = phi_68380_;
let _e24283 = (_e20752 == 0u);
if _e24283 {
phi_68431_ = 0u;
} else {
if (_e20752 == 1u) {
phi_68430_ = 0u;
} else {
if (_e20752 == 2u) {
phi_68429_ = _e23604;
} else {
phi_68429_ = select(_e23610, _e23607, (_e20752 == 3u));
}
let _e24289 = phi_68429_;
phi_68430_ = _e24289;
}
let _e24291 = phi_68430_;
phi_68431_ = _e24291;
}
let _e24293 = phi_68431_;
local_14 = (((bitcast<i32>(_e24293) + _e24280.member_1) * _e23601) + _e24280.member);
let _e24298 = local_14;
let _e24300 = select(_e23627, _e24298, (_e24298 < _e23627));
let _e24305 = global_6.member[bitcast<u32>(select(0i, _e24300, (_e24300 > 0i)))];
let _e24310 = (((((select(_e24270, _e24274, _e453) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e24315 = ((1f - (((select(_e24274, _e24270, _e453) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e24322 = ((_e23164.member * _e24310) + (_e23172.member * _e24315));
let _e24323 = ((_e23164.member_1 * _e24310) + (_e23172.member_1 * _e24315));
let _e24324 = ((_e23164.member_2 * _e24310) + (_e23172.member_2 * _e24315));
let _e24328 = select((_e23187.member + _e24322), _e23187.member, _e23185);
let _e24329 = select((_e23187.member_1 + _e24323), _e23187.member_1, _e23185);
let _e24330 = select((_e23187.member_2 + _e24324), _e23187.member_2, _e23185);
let _e24341 = (((_e24328 * _e24328) + (_e24329 * _e24329)) + (_e24330 * _e24330));
let _e24345 = (1f / sqrt(select(0f, _e24341, (_e24341 > 0f))));
let _e24346 = (_e24328 * _e24345);
let _e24347 = (_e24329 * _e24345);
let _e24348 = (_e24330 * _e24345);
let _e24349 = (_e575 - select(_e23198.member, (_e23198.member + _e24322), _e23185));
let _e24350 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e24323), _e23185));
let _e24351 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e24324), _e23185));
let _e24356 = (((_e24349 * _e24346) + (_e24350 * _e24347)) + (_e24351 * _e24348));
let _e24361 = (((_e24349 * _e613) + (_e24350 * _e626)) + (_e24351 * _e639));
let _e24366 = (((_e24346 * _e613) + (_e24347 * _e626)) + (_e24348 * _e639));
let _e24369 = ((_e24347 * _e639) - (_e24348 * _e626));
let _e24372 = ((_e24348 * _e613) - (_e24346 * _e639));
let _e24375 = ((_e24346 * _e626) - (_e24347 * _e613));
let _e24380 = (((_e24369 * _e24369) + (_e24372 * _e24372)) + (_e24375 * _e24375));
let _e24383 = (1f / select(1e-9f, _e24380, (_e24380 > 1e-9f)));
let _e24386 = ((_e24356 - (_e24366 * _e24361)) * _e24383);
let _e24389 = (((_e24366 * _e24356) - _e24361) * _e24383);
let _e24395 = select(0f, _e24386, (((_e24389 >= 0f) && (_e24389 < _e691)) && (_e24386 > 0f)));
let _e24397 = (_e24260 << bitcast<u32>(_e24191));
let _e24409 = (_e24232 + 1i);
let _e24412 = select(_e24409, 0i, (_e24409 < 0i));
let _e24413 = (_e24412 >= _e24207.member);
if _e24413 {
phi_69092_ = (_e24207.member - 1i);
} else {
phi_69092_ = _e24412;
}
let _e24416 = phi_69092_;
if _e24263 {
phi_69103_ = (_e24207.member_1 - 1i);
} else {
phi_69103_ = _e24262;
}
let _e24419 = phi_69103_;
let _e24423 = (((f32(_e24416) + 0.5f) * _e24212) - 0.5f);
let _e24427 = (((f32(_e24419) + 0.5f) * _e24212) - 0.5f);
if _e453 {
phi_69131_ = type_23(_e24419, _e24416);
} else {
phi_69131_ = type_23(_e24416, _e24419);
}
let _e24433 = phi_69131_;
if _e24283 {
phi_69182_ = 0u;
} else {
if (_e20752 == 1u) {
phi_69181_ = 0u;
} else {
if (_e20752 == 2u) {
phi_69180_ = _e23604;
} else {
phi_69180_ = select(_e23610, _e23607, (_e20752 == 3u));
}
let _e24441 = phi_69180_;
phi_69181_ = _e24441;
}
let _e24443 = phi_69181_;
phi_69182_ = _e24443;
}
let _e24445 = phi_69182_;
local_12 = (((bitcast<i32>(_e24445) + _e24433.member_1) * _e23601) + _e24433.member);
let _e24450 = local_12;
let _e24452 = select(_e23627, _e24450, (_e24450 < _e23627));
let _e24457 = global_6.member[bitcast<u32>(select(0i, _e24452, (_e24452 > 0i)))];
let _e24462 = (((((select(_e24423, _e24427, _e453) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e24467 = ((1f - (((select(_e24427, _e24423, _e453) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e24474 = ((_e23164.member * _e24462) + (_e23172.member * _e24467));
let _e24475 = ((_e23164.member_1 * _e24462) + (_e23172.member_1 * _e24467));
let _e24476 = ((_e23164.member_2 * _e24462) + (_e23172.member_2 * _e24467));
let _e24480 = select((_e23187.member + _e24474), _e23187.member, _e23185);
let _e24481 = select((_e23187.member_1 + _e24475), _e23187.member_1, _e23185);
let _e24482 = select((_e23187.member_2 + _e24476), _e23187.member_2, _e23185);
let _e24493 = (((_e24480 * _e24480) + (_e24481 * _e24481)) + (_e24482 * _e24482));
let _e24497 = (1f / sqrt(select(0f, _e24493, (_e24493 > 0f))));
let _e24498 = (_e24480 * _e24497);
let _e24499 = (_e24481 * _e24497);
let _e24500 = (_e24482 * _e24497);
let _e24501 = (_e575 - select(_e23198.member, (_e23198.member + _e24474), _e23185));
let _e24502 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e24475), _e23185));
let _e24503 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e24476), _e23185));
let _e24508 = (((_e24501 * _e24498) + (_e24502 * _e24499)) + (_e24503 * _e24500));
let _e24513 = (((_e24501 * _e613) + (_e24502 * _e626)) + (_e24503 * _e639));
let _e24518 = (((_e24498 * _e613) + (_e24499 * _e626)) + (_e24500 * _e639));
let _e24521 = ((_e24499 * _e639) - (_e24500 * _e626));
let _e24524 = ((_e24500 * _e613) - (_e24498 * _e639));
let _e24527 = ((_e24498 * _e626) - (_e24499 * _e613));
let _e24532 = (((_e24521 * _e24521) + (_e24524 * _e24524)) + (_e24527 * _e24527));
let _e24535 = (1f / select(1e-9f, _e24532, (_e24532 > 1e-9f)));
let _e24538 = ((_e24508 - (_e24518 * _e24513)) * _e24535);
let _e24541 = (((_e24518 * _e24508) - _e24513) * _e24535);
let _e24547 = select(0f, _e24538, (((_e24541 >= 0f) && (_e24541 < _e691)) && (_e24538 > 0f)));
let _e24549 = (_e24416 << bitcast<u32>(_e24191));
let _e24561 = (_e24247 + 1i);
if _e24257 {
phi_69843_ = (_e24207.member - 1i);
} else {
phi_69843_ = _e24256;
}
let _e24565 = phi_69843_;
let _e24567 = select(_e24561, 0i, (_e24561 < 0i));
let _e24568 = (_e24567 >= _e24207.member_1);
if _e24568 {
phi_69854_ = (_e24207.member_1 - 1i);
} else {
phi_69854_ = _e24567;
}
let _e24571 = phi_69854_;
let _e24575 = (((f32(_e24565) + 0.5f) * _e24212) - 0.5f);
let _e24579 = (((f32(_e24571) + 0.5f) * _e24212) - 0.5f);
if _e453 {
phi_69882_ = type_23(_e24571, _e24565);
} else {
phi_69882_ = type_23(_e24565, _e24571);
}
let _e24585 = phi_69882_;
if _e24283 {
phi_69933_ = 0u;
} else {
if (_e20752 == 1u) {
phi_69932_ = 0u;
} else {
if (_e20752 == 2u) {
phi_69931_ = _e23604;
} else {
phi_69931_ = select(_e23610, _e23607, (_e20752 == 3u));
}
let _e24593 = phi_69931_;
phi_69932_ = _e24593;
}
let _e24595 = phi_69932_;
phi_69933_ = _e24595;
}
let _e24597 = phi_69933_;
local_10 = (((bitcast<i32>(_e24597) + _e24585.member_1) * _e23601) + _e24585.member);
let _e24602 = local_10;
let _e24604 = select(_e23627, _e24602, (_e24602 < _e23627));
let _e24609 = global_6.member[bitcast<u32>(select(0i, _e24604, (_e24604 > 0i)))];
let _e24614 = (((((select(_e24575, _e24579, _e453) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e24619 = ((1f - (((select(_e24579, _e24575, _e453) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e24626 = ((_e23164.member * _e24614) + (_e23172.member * _e24619));
let _e24627 = ((_e23164.member_1 * _e24614) + (_e23172.member_1 * _e24619));
let _e24628 = ((_e23164.member_2 * _e24614) + (_e23172.member_2 * _e24619));
let _e24632 = select((_e23187.member + _e24626), _e23187.member, _e23185);
let _e24633 = select((_e23187.member_1 + _e24627), _e23187.member_1, _e23185);
let _e24634 = select((_e23187.member_2 + _e24628), _e23187.member_2, _e23185);
let _e24645 = (((_e24632 * _e24632) + (_e24633 * _e24633)) + (_e24634 * _e24634));
let _e24649 = (1f / sqrt(select(0f, _e24645, (_e24645 > 0f))));
let _e24650 = (_e24632 * _e24649);
let _e24651 = (_e24633 * _e24649);
let _e24652 = (_e24634 * _e24649);
let _e24653 = (_e575 - select(_e23198.member, (_e23198.member + _e24626), _e23185));
let _e24654 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e24627), _e23185));
let _e24655 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e24628), _e23185));
let _e24660 = (((_e24653 * _e24650) + (_e24654 * _e24651)) + (_e24655 * _e24652));
let _e24665 = (((_e24653 * _e613) + (_e24654 * _e626)) + (_e24655 * _e639));
let _e24670 = (((_e24650 * _e613) + (_e24651 * _e626)) + (_e24652 * _e639));
let _e24673 = ((_e24651 * _e639) - (_e24652 * _e626));
let _e24676 = ((_e24652 * _e613) - (_e24650 * _e639));
let _e24679 = ((_e24650 * _e626) - (_e24651 * _e613));
let _e24684 = (((_e24673 * _e24673) + (_e24676 * _e24676)) + (_e24679 * _e24679));
let _e24687 = (1f / select(1e-9f, _e24684, (_e24684 > 1e-9f)));
let _e24690 = ((_e24660 - (_e24670 * _e24665)) * _e24687);
let _e24693 = (((_e24670 * _e24660) - _e24665) * _e24687);
let _e24699 = select(0f, _e24690, (((_e24693 >= 0f) && (_e24693 < _e691)) && (_e24690 > 0f)));
let _e24701 = (_e24565 << bitcast<u32>(_e24191));
if _e24413 {
phi_70594_ = (_e24207.member - 1i);
} else {
phi_70594_ = _e24412;
}
let _e24716 = phi_70594_;
if _e24568 {
phi_70605_ = (_e24207.member_1 - 1i);
} else {
phi_70605_ = _e24567;
}
let _e24719 = phi_70605_;
let _e24723 = (((f32(_e24716) + 0.5f) * _e24212) - 0.5f);
let _e24727 = (((f32(_e24719) + 0.5f) * _e24212) - 0.5f);
if _e453 {
phi_70633_ = type_23(_e24719, _e24716);
} else {
phi_70633_ = type_23(_e24716, _e24719);
}
let _e24733 = phi_70633_;
if _e24283 {
phi_70684_ = 0u;
} else {
if (_e20752 == 1u) {
phi_70683_ = 0u;
} else {
if (_e20752 == 2u) {
phi_70682_ = _e23604;
} else {
phi_70682_ = select(_e23610, _e23607, (_e20752 == 3u));
}
let _e24741 = phi_70682_;
phi_70683_ = _e24741;
}
let _e24743 = phi_70683_;
phi_70684_ = _e24743;
}
let _e24745 = phi_70684_;
local_8 = (((bitcast<i32>(_e24745) + _e24733.member_1) * _e23601) + _e24733.member);
let _e24750 = local_8;
let _e24752 = select(_e23627, _e24750, (_e24750 < _e23627));
let _e24757 = global_6.member[bitcast<u32>(select(0i, _e24752, (_e24752 > 0i)))];
let _e24762 = (((((select(_e24723, _e24727, _e453) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e24767 = ((1f - (((select(_e24727, _e24723, _e453) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e24774 = ((_e23164.member * _e24762) + (_e23172.member * _e24767));
let _e24775 = ((_e23164.member_1 * _e24762) + (_e23172.member_1 * _e24767));
let _e24776 = ((_e23164.member_2 * _e24762) + (_e23172.member_2 * _e24767));
let _e24780 = select((_e23187.member + _e24774), _e23187.member, _e23185);
let _e24781 = select((_e23187.member_1 + _e24775), _e23187.member_1, _e23185);
let _e24782 = select((_e23187.member_2 + _e24776), _e23187.member_2, _e23185);
let _e24793 = (((_e24780 * _e24780) + (_e24781 * _e24781)) + (_e24782 * _e24782));
let _e24797 = (1f / sqrt(select(0f, _e24793, (_e24793 > 0f))));
let _e24798 = (_e24780 * _e24797);
let _e24799 = (_e24781 * _e24797);
let _e24800 = (_e24782 * _e24797);
let _e24801 = (_e575 - select(_e23198.member, (_e23198.member + _e24774), _e23185));
let _e24802 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e24775), _e23185));
let _e24803 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e24776), _e23185));
let _e24808 = (((_e24801 * _e24798) + (_e24802 * _e24799)) + (_e24803 * _e24800));
let _e24813 = (((_e24801 * _e613) + (_e24802 * _e626)) + (_e24803 * _e639));
let _e24818 = (((_e24798 * _e613) + (_e24799 * _e626)) + (_e24800 * _e639));
let _e24821 = ((_e24799 * _e639) - (_e24800 * _e626));
let _e24824 = ((_e24800 * _e613) - (_e24798 * _e639));
let _e24827 = ((_e24798 * _e626) - (_e24799 * _e613));
let _e24832 = (((_e24821 * _e24821) + (_e24824 * _e24824)) + (_e24827 * _e24827));
let _e24835 = (1f / select(1e-9f, _e24832, (_e24832 > 1e-9f)));
let _e24838 = ((_e24808 - (_e24818 * _e24813)) * _e24835);
let _e24841 = (((_e24818 * _e24808) - _e24813) * _e24835);
let _e24847 = select(0f, _e24838, (((_e24841 >= 0f) && (_e24841 < _e691)) && (_e24838 > 0f)));
let _e24849 = (_e24716 << bitcast<u32>(_e24191));
let _e24861 = select(((((_e24190 - select(0f, (_e24252 * _e24253), (((select(select(_e766, _e923, (_e24397 >= _e692)), _e845, (_e24397 < _e298)) == _e20752) && (_e24395 > 0f)) && (_e24395 < _e24305)))) - select(0f, (_e24249 * _e24253), (((select(select(_e766, _e923, (_e24549 >= _e692)), _e845, (_e24549 < _e298)) == _e20752) && (_e24547 > 0f)) && (_e24547 < _e24457)))) - select(0f, (_e24252 * _e24251), (((select(select(_e766, _e923, (_e24701 >= _e692)), _e845, (_e24701 < _e298)) == _e20752) && (_e24699 > 0f)) && (_e24699 < _e24609)))) - select(0f, (_e24249 * _e24251), (((select(select(_e766, _e923, (_e24849 >= _e692)), _e845, (_e24849 < _e298)) == _e20752) && (_e24847 > 0f)) && (_e24847 < _e24757)))), _e24190, _e24283);
let _e24862 = (_e20756 & 31u);
let _e24864 = (1u << bitcast<u32>(_e24862));
let _e24873 = bitcast<i32>((((_e14757 + _e24864) - 1u) >> bitcast<u32>(_e24862)));
let _e24874 = bitcast<i32>((((_e14760 + _e24864) - 1u) >> bitcast<u32>(_e24862)));
if _e453 {
phi_71363_ = type_23(_e24874, _e24873);
} else {
phi_71363_ = type_23(_e24873, _e24874);
}
let _e24878 = phi_71363_;
let _e24883 = f32((1i << bitcast<u32>(_e24862)));
let _e24884 = (1f / _e24883);
let _e24886 = ((_e22971 * _e24884) - 0.5f);
let _e24888 = ((_e23065 * _e24884) - 0.5f);
let _e24890 = select(-1f, _e24886, (_e24886 > -1f));
let _e24892 = select(1e6f, _e24890, (_e24890 < 1e6f));
let _e24899 = select(0i, select(select(i32(_e24892), i32(-2147483648), (_e24892 < -2147483600f)), 2147483647i, (_e24892 > 2147483500f)), (_e24892 == _e24892));
let _e24903 = (_e24899 - select(0i, 1i, (_e24892 < f32(_e24899))));
let _e24905 = select(-1f, _e24888, (_e24888 > -1f));
let _e24907 = select(1e6f, _e24905, (_e24905 < 1e6f));
let _e24914 = select(0i, select(select(i32(_e24907), i32(-2147483648), (_e24907 < -2147483600f)), 2147483647i, (_e24907 > 2147483500f)), (_e24907 == _e24907));
let _e24918 = (_e24914 - select(0i, 1i, (_e24907 < f32(_e24914))));
let _e24920 = (_e24886 - f32(_e24903));
let _e24922 = (_e24888 - f32(_e24918));
let _e24923 = (1f - _e24920);
let _e24924 = (1f - _e24922);
let _e24927 = select(_e24903, 0i, (_e24903 < 0i));
let _e24928 = (_e24927 >= _e24878.member);
if _e24928 {
phi_71441_ = (_e24878.member - 1i);
} else {
phi_71441_ = _e24927;
}
let _e24931 = phi_71441_;
let _e24933 = select(_e24918, 0i, (_e24918 < 0i));
let _e24934 = (_e24933 >= _e24878.member_1);
if _e24934 {
phi_71452_ = (_e24878.member_1 - 1i);
} else {
phi_71452_ = _e24933;
}
let _e24937 = phi_71452_;
let _e24941 = (((f32(_e24931) + 0.5f) * _e24883) - 0.5f);
let _e24945 = (((f32(_e24937) + 0.5f) * _e24883) - 0.5f);
if _e453 {
phi_71480_ = type_23(_e24937, _e24931);
} else {
phi_71480_ = type_23(_e24931, _e24937);
}
let _e24951 = phi_71480_;
let _e24954 = (_e20756 == 0u);
if _e24954 {
phi_71531_ = 0u;
} else {
if (_e20756 == 1u) {
phi_71530_ = 0u;
} else {
if (_e20756 == 2u) {
phi_71529_ = _e23604;
} else {
phi_71529_ = select(_e23610, _e23607, (_e20756 == 3u));
}
let _e24960 = phi_71529_;
phi_71530_ = _e24960;
}
let _e24962 = phi_71530_;
phi_71531_ = _e24962;
}
let _e24964 = phi_71531_;
local_6 = (((bitcast<i32>(_e24964) + _e24951.member_1) * _e23601) + _e24951.member);
let _e24969 = local_6;
let _e24971 = select(_e23627, _e24969, (_e24969 < _e23627));
let _e24976 = global_6.member[bitcast<u32>(select(0i, _e24971, (_e24971 > 0i)))];
let _e24981 = (((((select(_e24941, _e24945, _e453) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e24986 = ((1f - (((select(_e24945, _e24941, _e453) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e24993 = ((_e23164.member * _e24981) + (_e23172.member * _e24986));
let _e24994 = ((_e23164.member_1 * _e24981) + (_e23172.member_1 * _e24986));
let _e24995 = ((_e23164.member_2 * _e24981) + (_e23172.member_2 * _e24986));
let _e24999 = select((_e23187.member + _e24993), _e23187.member, _e23185);
let _e25000 = select((_e23187.member_1 + _e24994), _e23187.member_1, _e23185);
let _e25001 = select((_e23187.member_2 + _e24995), _e23187.member_2, _e23185);
let _e25012 = (((_e24999 * _e24999) + (_e25000 * _e25000)) + (_e25001 * _e25001));
let _e25016 = (1f / sqrt(select(0f, _e25012, (_e25012 > 0f))));
let _e25017 = (_e24999 * _e25016);
let _e25018 = (_e25000 * _e25016);
let _e25019 = (_e25001 * _e25016);
let _e25020 = (_e575 - select(_e23198.member, (_e23198.member + _e24993), _e23185));
let _e25021 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e24994), _e23185));
let _e25022 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e24995), _e23185));
let _e25027 = (((_e25020 * _e25017) + (_e25021 * _e25018)) + (_e25022 * _e25019));
let _e25032 = (((_e25020 * _e613) + (_e25021 * _e626)) + (_e25022 * _e639));
let _e25037 = (((_e25017 * _e613) + (_e25018 * _e626)) + (_e25019 * _e639));
let _e25040 = ((_e25018 * _e639) - (_e25019 * _e626));
let _e25043 = ((_e25019 * _e613) - (_e25017 * _e639));
let _e25046 = ((_e25017 * _e626) - (_e25018 * _e613));
let _e25051 = (((_e25040 * _e25040) + (_e25043 * _e25043)) + (_e25046 * _e25046));
let _e25054 = (1f / select(1e-9f, _e25051, (_e25051 > 1e-9f)));
let _e25057 = ((_e25027 - (_e25037 * _e25032)) * _e25054);
let _e25060 = (((_e25037 * _e25027) - _e25032) * _e25054);
let _e25066 = select(0f, _e25057, (((_e25060 >= 0f) && (_e25060 < _e691)) && (_e25057 > 0f)));
let _e25068 = (_e24931 << bitcast<u32>(_e24862));
let _e25080 = (_e24903 + 1i);
let _e25083 = select(_e25080, 0i, (_e25080 < 0i));
let _e25084 = (_e25083 >= _e24878.member);
if _e25084 {
phi_72192_ = (_e24878.member - 1i);
} else {
phi_72192_ = _e25083;
}
let _e25087 = phi_72192_;
if _e24934 {
phi_72203_ = (_e24878.member_1 - 1i);
} else {
phi_72203_ = _e24933;
}
let _e25090 = phi_72203_;
let _e25094 = (((f32(_e25087) + 0.5f) * _e24883) - 0.5f);
let _e25098 = (((f32(_e25090) + 0.5f) * _e24883) - 0.5f);
if _e453 {
phi_72231_ = type_23(_e25090, _e25087);
} else {
phi_72231_ = type_23(_e25087, _e25090);
}
let _e25104 = phi_72231_;
if _e24954 {
phi_72282_ = 0u;
} else {
if (_e20756 == 1u) {
phi_72281_ = 0u;
} else {
if (_e20756 == 2u) {
phi_72280_ = _e23604;
} else {
phi_72280_ = select(_e23610, _e23607, (_e20756 == 3u));
}
let _e25112 = phi_72280_;
phi_72281_ = _e25112;
}
let _e25114 = phi_72281_;
phi_72282_ = _e25114;
}
let _e25116 = phi_72282_;
local_4 = (((bitcast<i32>(_e25116) + _e25104.member_1) * _e23601) + _e25104.member);
let _e25121 = local_4;
let _e25123 = select(_e23627, _e25121, (_e25121 < _e23627));
let _e25128 = global_6.member[bitcast<u32>(select(0i, _e25123, (_e25123 > 0i)))];
let _e25133 = (((((select(_e25094, _e25098, _e453) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e25138 = ((1f - (((select(_e25098, _e25094, _e453) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e25145 = ((_e23164.member * _e25133) + (_e23172.member * _e25138));
let _e25146 = ((_e23164.member_1 * _e25133) + (_e23172.member_1 * _e25138));
let _e25147 = ((_e23164.member_2 * _e25133) + (_e23172.member_2 * _e25138));
let _e25151 = select((_e23187.member + _e25145), _e23187.member, _e23185);
let _e25152 = select((_e23187.member_1 + _e25146), _e23187.member_1, _e23185);
let _e25153 = select((_e23187.member_2 + _e25147), _e23187.member_2, _e23185);
let _e25164 = (((_e25151 * _e25151) + (_e25152 * _e25152)) + (_e25153 * _e25153));
let _e25168 = (1f / sqrt(select(0f, _e25164, (_e25164 > 0f))));
let _e25169 = (_e25151 * _e25168);
let _e25170 = (_e25152 * _e25168);
let _e25171 = (_e25153 * _e25168);
let _e25172 = (_e575 - select(_e23198.member, (_e23198.member + _e25145), _e23185));
let _e25173 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e25146), _e23185));
let _e25174 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e25147), _e23185));
let _e25179 = (((_e25172 * _e25169) + (_e25173 * _e25170)) + (_e25174 * _e25171));
let _e25184 = (((_e25172 * _e613) + (_e25173 * _e626)) + (_e25174 * _e639));
let _e25189 = (((_e25169 * _e613) + (_e25170 * _e626)) + (_e25171 * _e639));
let _e25192 = ((_e25170 * _e639) - (_e25171 * _e626));
let _e25195 = ((_e25171 * _e613) - (_e25169 * _e639));
let _e25198 = ((_e25169 * _e626) - (_e25170 * _e613));
let _e25203 = (((_e25192 * _e25192) + (_e25195 * _e25195)) + (_e25198 * _e25198));
let _e25206 = (1f / select(1e-9f, _e25203, (_e25203 > 1e-9f)));
let _e25209 = ((_e25179 - (_e25189 * _e25184)) * _e25206);
let _e25212 = (((_e25189 * _e25179) - _e25184) * _e25206);
let _e25218 = select(0f, _e25209, (((_e25212 >= 0f) && (_e25212 < _e691)) && (_e25209 > 0f)));
let _e25220 = (_e25087 << bitcast<u32>(_e24862));
let _e25232 = (_e24918 + 1i);
if _e24928 {
phi_72943_ = (_e24878.member - 1i);
} else {
phi_72943_ = _e24927;
}
let _e25236 = phi_72943_;
let _e25238 = select(_e25232, 0i, (_e25232 < 0i));
let _e25239 = (_e25238 >= _e24878.member_1);
if _e25239 {
phi_72954_ = (_e24878.member_1 - 1i);
} else {
phi_72954_ = _e25238;
}
let _e25242 = phi_72954_;
let _e25246 = (((f32(_e25236) + 0.5f) * _e24883) - 0.5f);
let _e25250 = (((f32(_e25242) + 0.5f) * _e24883) - 0.5f);
if _e453 {
phi_72982_ = type_23(_e25242, _e25236);
} else {
phi_72982_ = type_23(_e25236, _e25242);
}
let _e25256 = phi_72982_;
if _e24954 {
phi_73033_ = 0u;
} else {
if (_e20756 == 1u) {
phi_73032_ = 0u;
} else {
if (_e20756 == 2u) {
phi_73031_ = _e23604;
} else {
phi_73031_ = select(_e23610, _e23607, (_e20756 == 3u));
}
let _e25264 = phi_73031_;
phi_73032_ = _e25264;
}
let _e25266 = phi_73032_;
phi_73033_ = _e25266;
}
let _e25268 = phi_73033_;
local_2 = (((bitcast<i32>(_e25268) + _e25256.member_1) * _e23601) + _e25256.member);
let _e25273 = local_2;
let _e25275 = select(_e23627, _e25273, (_e25273 < _e23627));
let _e25280 = global_6.member[bitcast<u32>(select(0i, _e25275, (_e25275 > 0i)))];
let _e25285 = (((((select(_e25246, _e25250, _e453) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e25290 = ((1f - (((select(_e25250, _e25246, _e453) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e25297 = ((_e23164.member * _e25285) + (_e23172.member * _e25290));
let _e25298 = ((_e23164.member_1 * _e25285) + (_e23172.member_1 * _e25290));
let _e25299 = ((_e23164.member_2 * _e25285) + (_e23172.member_2 * _e25290));
let _e25303 = select((_e23187.member + _e25297), _e23187.member, _e23185);
let _e25304 = select((_e23187.member_1 + _e25298), _e23187.member_1, _e23185);
let _e25305 = select((_e23187.member_2 + _e25299), _e23187.member_2, _e23185);
let _e25316 = (((_e25303 * _e25303) + (_e25304 * _e25304)) + (_e25305 * _e25305));
let _e25320 = (1f / sqrt(select(0f, _e25316, (_e25316 > 0f))));
let _e25321 = (_e25303 * _e25320);
let _e25322 = (_e25304 * _e25320);
let _e25323 = (_e25305 * _e25320);
let _e25324 = (_e575 - select(_e23198.member, (_e23198.member + _e25297), _e23185));
let _e25325 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e25298), _e23185));
let _e25326 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e25299), _e23185));
let _e25331 = (((_e25324 * _e25321) + (_e25325 * _e25322)) + (_e25326 * _e25323));
let _e25336 = (((_e25324 * _e613) + (_e25325 * _e626)) + (_e25326 * _e639));
let _e25341 = (((_e25321 * _e613) + (_e25322 * _e626)) + (_e25323 * _e639));
let _e25344 = ((_e25322 * _e639) - (_e25323 * _e626));
let _e25347 = ((_e25323 * _e613) - (_e25321 * _e639));
let _e25350 = ((_e25321 * _e626) - (_e25322 * _e613));
let _e25355 = (((_e25344 * _e25344) + (_e25347 * _e25347)) + (_e25350 * _e25350));
let _e25358 = (1f / select(1e-9f, _e25355, (_e25355 > 1e-9f)));
let _e25361 = ((_e25331 - (_e25341 * _e25336)) * _e25358);
let _e25364 = (((_e25341 * _e25331) - _e25336) * _e25358);
let _e25370 = select(0f, _e25361, (((_e25364 >= 0f) && (_e25364 < _e691)) && (_e25361 > 0f)));
let _e25372 = (_e25236 << bitcast<u32>(_e24862));
if _e25084 {
phi_73694_ = (_e24878.member - 1i);
} else {
phi_73694_ = _e25083;
}
let _e25387 = phi_73694_;
if _e25239 {
phi_73705_ = (_e24878.member_1 - 1i);
} else {
phi_73705_ = _e25238;
}
let _e25390 = phi_73705_;
let _e25394 = (((f32(_e25387) + 0.5f) * _e24883) - 0.5f);
let _e25398 = (((f32(_e25390) + 0.5f) * _e24883) - 0.5f);
if _e453 {
phi_73733_ = type_23(_e25390, _e25387);
} else {
phi_73733_ = type_23(_e25387, _e25390);
}
let _e25404 = phi_73733_;
if _e24954 {
phi_73784_ = 0u;
} else {
if (_e20756 == 1u) {
phi_73783_ = 0u;
} else {
if (_e20756 == 2u) {
phi_73782_ = _e23604;
} else {
phi_73782_ = select(_e23610, _e23607, (_e20756 == 3u));
}
let _e25412 = phi_73782_;
phi_73783_ = _e25412;
}
let _e25414 = phi_73783_;
phi_73784_ = _e25414;
}
let _e25416 = phi_73784_;
local = (((bitcast<i32>(_e25416) + _e25404.member_1) * _e23601) + _e25404.member);
let _e25421 = local;
let _e25423 = select(_e23627, _e25421, (_e25421 < _e23627));
let _e25428 = global_6.member[bitcast<u32>(select(0i, _e25423, (_e25423 > 0i)))];
let _e25433 = (((((select(_e25394, _e25398, _e453) + 0.5f) / _e23145) * 2f) - 1f) * _e23153);
let _e25438 = ((1f - (((select(_e25398, _e25394, _e453) + 0.5f) / _e23146) * 2f)) * _e23161);
let _e25445 = ((_e23164.member * _e25433) + (_e23172.member * _e25438));
let _e25446 = ((_e23164.member_1 * _e25433) + (_e23172.member_1 * _e25438));
let _e25447 = ((_e23164.member_2 * _e25433) + (_e23172.member_2 * _e25438));
let _e25451 = select((_e23187.member + _e25445), _e23187.member, _e23185);
let _e25452 = select((_e23187.member_1 + _e25446), _e23187.member_1, _e23185);
let _e25453 = select((_e23187.member_2 + _e25447), _e23187.member_2, _e23185);
let _e25464 = (((_e25451 * _e25451) + (_e25452 * _e25452)) + (_e25453 * _e25453));
let _e25468 = (1f / sqrt(select(0f, _e25464, (_e25464 > 0f))));
let _e25469 = (_e25451 * _e25468);
let _e25470 = (_e25452 * _e25468);
let _e25471 = (_e25453 * _e25468);
let _e25472 = (_e575 - select(_e23198.member, (_e23198.member + _e25445), _e23185));
let _e25473 = (_e587 - select(_e23198.member_1, (_e23198.member_1 + _e25446), _e23185));
let _e25474 = (_e600 - select(_e23198.member_2, (_e23198.member_2 + _e25447), _e23185));
let _e25479 = (((_e25472 * _e25469) + (_e25473 * _e25470)) + (_e25474 * _e25471));
let _e25484 = (((_e25472 * _e613) + (_e25473 * _e626)) + (_e25474 * _e639));
let _e25489 = (((_e25469 * _e613) + (_e25470 * _e626)) + (_e25471 * _e639));
let _e25492 = ((_e25470 * _e639) - (_e25471 * _e626));
let _e25495 = ((_e25471 * _e613) - (_e25469 * _e639));
let _e25498 = ((_e25469 * _e626) - (_e25470 * _e613));
let _e25503 = (((_e25492 * _e25492) + (_e25495 * _e25495)) + (_e25498 * _e25498));
let _e25506 = (1f / select(1e-9f, _e25503, (_e25503 > 1e-9f)));
let _e25509 = ((_e25479 - (_e25489 * _e25484)) * _e25506);
let _e25512 = (((_e25489 * _e25479) - _e25484) * _e25506);
let _e25518 = select(0f, _e25509, (((_e25512 >= 0f) && (_e25512 < _e691)) && (_e25509 > 0f)));
let _e25520 = (_e25387 << bitcast<u32>(_e24862));
let _e25532 = select(((((_e24861 - select(0f, (_e24923 * _e24924), (((select(select(_e766, _e923, (_e25068 >= _e692)), _e845, (_e25068 < _e298)) == _e20756) && (_e25066 > 0f)) && (_e25066 < _e24976)))) - select(0f, (_e24920 * _e24924), (((select(select(_e766, _e923, (_e25220 >= _e692)), _e845, (_e25220 < _e298)) == _e20756) && (_e25218 > 0f)) && (_e25218 < _e25128)))) - select(0f, (_e24923 * _e24922), (((select(select(_e766, _e923, (_e25372 >= _e692)), _e845, (_e25372 < _e298)) == _e20756) && (_e25370 > 0f)) && (_e25370 < _e25280)))) - select(0f, (_e24920 * _e24922), (((select(select(_e766, _e923, (_e25520 >= _e692)), _e845, (_e25520 < _e298)) == _e20756) && (_e25518 > 0f)) && (_e25518 < _e25428)))), _e24861, _e24954);
if _e453 {
phi_74454_ = type_23(_e23062, _e22969);
} else {
phi_74454_ = type_23(_e22969, _e23062);
}
let _e25547 = phi_74454_;
let _e25550 = (_e23063 && (((_e23518 > 0f) && (_e23518 < _e23142)) && (bitcast<f32>((bitcast<u32>(_e25532) & 2147483647u)) > 1e-6f)));
let _e25553 = global_1.member.member_18.member;
let _e25554 = (((select(_e23088, (1f - _e23088), (_e23073 >= 0f)) - select(_e23107, (1f - _e23107), (_e23092 >= 0f))) * (1f / _e23070)) * _e25553);
let _e25558 = select(0f, (((((_e652 * _e23355.member) * ((1f + (_e23395 * (1f + (_e23395 * (0.5f + (_e23395 * (0.16666667f + (_e23395 * (0.041666668f + (_e23395 * (0.008333334f + (_e23395 * (0.001388889f + (_e23395 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e23390 + 127i)) << bitcast<u32>(23i))))) * _e23348) * _e25532) * _e25554), _e25550);
let _e25559 = select(0f, (((((_e665 * _e23355.member_1) * ((1f + (_e23443 * (1f + (_e23443 * (0.5f + (_e23443 * (0.16666667f + (_e23443 * (0.041666668f + (_e23443 * (0.008333334f + (_e23443 * (0.001388889f + (_e23443 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e23438 + 127i)) << bitcast<u32>(23i))))) * _e23348) * _e25532) * _e25554), _e25550);
let _e25560 = select(0f, (((((_e678 * _e23355.member_2) * ((1f + (_e23491 * (1f + (_e23491 * (0.5f + (_e23491 * (0.16666667f + (_e23491 * (0.041666668f + (_e23491 * (0.008333334f + (_e23491 * (0.001388889f + (_e23491 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e23486 + 127i)) << bitcast<u32>(23i))))) * _e23348) * _e25532) * _e25554), _e25550);
let _e25564 = (bitcast<f32>((bitcast<u32>(_e25558) & 2147483647u)) >= 1073741800f);
let _e25565 = (1f / 1048576f);
let _e25568 = ((_e25558 * select(1f, _e25565, _e25564)) + 0.5f);
let _e25570 = select(-1073741800f, _e25568, (_e25568 > -1073741800f));
let _e25572 = select(1073741800f, _e25570, (_e25570 < 1073741800f));
let _e25579 = select(0i, select(select(i32(_e25572), i32(-2147483648), (_e25572 < -2147483600f)), 2147483647i, (_e25572 > 2147483500f)), (_e25572 == _e25572));
let _e25583 = (_e25579 - select(0i, 1i, (_e25572 < f32(_e25579))));
let _e25584 = select(0i, 20i, _e25564);
let _e25588 = (bitcast<u32>(_e25583) << bitcast<u32>((_e25584 & 31i)));
let _e25595 = bitcast<u32>(((_e25583 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e25584) & 31i))));
let _e25599 = (bitcast<f32>((bitcast<u32>(_e25559) & 2147483647u)) >= 1073741800f);
let _e25602 = ((_e25559 * select(1f, _e25565, _e25599)) + 0.5f);
let _e25604 = select(-1073741800f, _e25602, (_e25602 > -1073741800f));
let _e25606 = select(1073741800f, _e25604, (_e25604 < 1073741800f));
let _e25613 = select(0i, select(select(i32(_e25606), i32(-2147483648), (_e25606 < -2147483600f)), 2147483647i, (_e25606 > 2147483500f)), (_e25606 == _e25606));
let _e25617 = (_e25613 - select(0i, 1i, (_e25606 < f32(_e25613))));
let _e25618 = select(0i, 20i, _e25599);
let _e25622 = (bitcast<u32>(_e25617) << bitcast<u32>((_e25618 & 31i)));
let _e25629 = bitcast<u32>(((_e25617 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e25618) & 31i))));
let _e25633 = (bitcast<f32>((bitcast<u32>(_e25560) & 2147483647u)) >= 1073741800f);
let _e25636 = ((_e25560 * select(1f, _e25565, _e25633)) + 0.5f);
let _e25638 = select(-1073741800f, _e25636, (_e25636 > -1073741800f));
let _e25640 = select(1073741800f, _e25638, (_e25638 < 1073741800f));
let _e25647 = select(0i, select(select(i32(_e25640), i32(-2147483648), (_e25640 < -2147483600f)), 2147483647i, (_e25640 > 2147483500f)), (_e25640 == _e25640));
let _e25651 = (_e25647 - select(0i, 1i, (_e25640 < f32(_e25647))));
let _e25652 = select(0i, 20i, _e25633);
let _e25656 = (bitcast<u32>(_e25651) << bitcast<u32>((_e25652 & 31i)));
let _e25663 = bitcast<u32>(((_e25651 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e25652) & 31i))));
let _e25668 = bitcast<i32>(bitcast<u32>((((_e25547.member_1 * _e14761) + _e25547.member) * 6i)));
if ((_e25588 | _e25595) == 0u) {
} else {
let _e25671 = bitcast<u32>(_e25668);
if (_e25671 < _e270) {
let _e25675 = atomicAdd((&global_8.member[_e25671]), _e25588);
phi_74687_ = _e25675;
} else {
phi_74687_ = 0u;
}
let _e25677 = phi_74687_;
let _e25681 = (_e25595 + select(0u, 1u, ((_e25677 + _e25588) < _e25588)));
if (_e25681 == 0u) {
} else {
let _e25683 = (_e25671 + 1u);
if (_e25683 < _e270) {
let _e25687 = atomicAdd((&global_8.member[_e25683]), _e25681);
}
}
}
if ((_e25622 | _e25629) == 0u) {
} else {
let _e25691 = bitcast<u32>((_e25668 + 2i));
if (_e25691 < _e270) {
let _e25695 = atomicAdd((&global_8.member[_e25691]), _e25622);
phi_74717_ = _e25695;
} else {
phi_74717_ = 0u;
}
let _e25697 = phi_74717_;
let _e25701 = (_e25629 + select(0u, 1u, ((_e25697 + _e25622) < _e25622)));
if (_e25701 == 0u) {
} else {
let _e25703 = (_e25691 + 1u);
if (_e25703 < _e270) {
let _e25707 = atomicAdd((&global_8.member[_e25703]), _e25701);
}
}
}
if ((_e25656 | _e25663) == 0u) {
} else {
let _e25711 = bitcast<u32>((_e25668 + 4i));
if (_e25711 < _e270) {
let _e25715 = atomicAdd((&global_8.member[_e25711]), _e25656);
phi_74747_ = _e25715;
} else {
phi_74747_ = 0u;
}
let _e25717 = phi_74747_;
let _e25721 = (_e25663 + select(0u, 1u, ((_e25717 + _e25656) < _e25656)));
if (_e25721 == 0u) {
} else {
let _e25723 = (_e25711 + 1u);
if (_e25723 < _e270) {
let _e25727 = atomicAdd((&global_8.member[_e25723]), _e25721);
}
}
}
phi_64363_ = (_e23060 + 1i);
} else {
phi_64363_ = i32();
}
let _e25730 = phi_64363_;
continue;
continuing {
phi_64362_ = _e25730;
break if !(_e23063);
}
}
phi_64209_ = (_e22966 + 1i);
} else {
phi_64209_ = i32();
}
let _e25734 = phi_64209_;
continue;
continuing {
phi_64208_ = _e25734;
break if !(_e22967);
}
}
}
}
}
}
}
}
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
